"""Runs the visible tests of an assignment on a student's file."""

import importlib.util
import os
import sys
import traceback
from collections.abc import Generator
from pathlib import Path

import pytest

from tam570.course import folder

__all__ = ["check"]


def check(file: Path, slug: str) -> int:
    """Run the tests beside the file, else the released ones, on it; 0 if all pass, 1 if some fail."""
    beside = file.parent / f"test_{slug}.py"
    tests = beside if beside.exists() else folder(slug) / beside.name
    if not _imported(file, slug):
        return 1
    options = ["-q", "--no-header", "--tb=short", "--import-mode=importlib", "-p", "no:cacheprovider"]
    options += [f"--rootdir={tests.parent}", "-c", os.devnull, str(tests)]
    outcome = pytest.main(options, plugins=[Unwritten()])
    return 0 if outcome == pytest.ExitCode.OK else 1


class Unwritten:
    """Says of a stub that it is not written yet, instead of showing where it raised."""

    @pytest.hookimpl(wrapper=True)
    def pytest_pyfunc_call(self) -> Generator[None, object, object]:
        try:
            return (yield)
        except NotImplementedError as error:
            *_, last = traceback.walk_tb(error.__traceback__)
            name = last[0].f_code.co_name
        return pytest.fail(f"{name} is not written yet", pytrace=False)


def _imported(file: Path, slug: str) -> bool:
    """Import the student's file under the assignment's name, which the tests use; say why if it cannot be."""
    spec = importlib.util.spec_from_file_location(slug, file)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[slug] = module
    try:
        spec.loader.exec_module(module)
    except (Exception, SystemExit) as error:
        lines = traceback.format_exception(error)
        print(f"{file} cannot be imported:\n{''.join(lines[-3:])}", file=sys.stderr)
        return False
    return True
