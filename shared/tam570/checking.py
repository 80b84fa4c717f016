"""Runs the visible tests of an assignment on a student's file."""

import contextlib
import importlib.util
import io
import os
import sys
import tempfile
import time
import traceback
from collections.abc import Generator, Sequence
from pathlib import Path

import pytest

from tam570.changes import calls, keys
from tam570.course import folder
from tam570.progress import FAILED, PASSED, kept, progress, remember, said

__all__ = ["check", "tests_of", "warm_up"]

OPTIONS = ("-q", "--no-header", "--tb=short", "--import-mode=importlib", "-p", "no:cacheprovider", "-c", os.devnull)


def check(file: Path, slug: str, *, changed: bool = False) -> int:
    """Run the tests beside the file, else the released ones, on it; 0 if all pass, 1 if some fail.

    changed : run only those whose outcome may have become another since they were run last
    """
    tests = tests_of(file, slug)
    if not _imported(file, slug):
        return 1
    asked, code = (path.read_text(encoding="utf-8") for path in (tests, file))
    try:
        now = keys(asked, code, slug)
    except SyntaxError:  # in the tests; pytest says it best
        return min(_run([str(tests)], tests, Outcomes()), 1)
    known = {test: was for test, was in kept(file).items() if was[0] == now.get(test)} if changed else {}
    found = Outcomes()
    chosen = [f"{tests}::{test}" for test in now if test not in known] if known else [str(tests)]
    status = _run(chosen, tests, found)
    failing = [test for test, (_, outcome) in known.items() if outcome != PASSED]
    if failing:
        print(f"as before, these fail: {', '.join(failing)}")
    known |= {test: (now[test], outcome) for test, outcome in found.outcomes.items() if test in now}
    outcomes = {test: outcome for test, (_, outcome) in known.items()}
    come = progress(slug, outcomes, calls(asked, slug))
    remember(file, known, come)
    since = f" ({time.time() - file.stat().st_mtime:.2f} s after saving)" if changed else ""
    print(f"{slug[:4]}: {said(come)}{since}", flush=True)
    return 0 if status == pytest.ExitCode.OK and all(one == PASSED for one in outcomes.values()) else 1


def tests_of(file: Path, slug: str) -> Path:
    """The tests beside the file, else the released ones."""
    beside = file.parent / f"test_{slug}.py"
    return beside if beside.exists() else folder(slug) / beside.name


def _run(chosen: Sequence[str], tests: Path, found: "Outcomes") -> int:
    """Run these tests; pytest's exit code."""
    if not chosen:
        print("nothing has changed that a test sees")
        return pytest.ExitCode.OK
    return _pytest(tests.parent, chosen, [Unwritten(), found])


def _pytest(root: Path, chosen: Sequence[str], plugins: Sequence[object]) -> int:
    """pytest by itself: plugins that happen to be installed take longer to load than the tests to run."""
    os.environ.setdefault("PYTEST_DISABLE_PLUGIN_AUTOLOAD", "1")
    return pytest.main([*OPTIONS, f"--rootdir={root}", *chosen], plugins=plugins)


def warm_up() -> None:
    """Let pytest import all that it imports on its first run."""
    with tempfile.TemporaryDirectory() as empty, contextlib.redirect_stdout(io.StringIO()):
        _pytest(Path(empty), [empty], [])


class Outcomes:
    """Notes how each test went; of one with several parameters, the worst."""

    def __init__(self) -> None:
        self.outcomes: dict[str, str] = {}

    @pytest.hookimpl
    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        test = report.nodeid.split("::")[1].partition("[")[0]
        if report.failed:
            self.outcomes[test] = FAILED
        elif report.when == "call":
            self.outcomes.setdefault(test, PASSED)


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
