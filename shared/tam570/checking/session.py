"""Runs the visible tests of an assignment on a student's file; meant for a process that may be ended."""

import contextlib
import io
import os
import sys
import tempfile
import time
import warnings
from collections.abc import Mapping, Sequence
from pathlib import Path

import pytest

from tam570.bans import HERE
from tam570.checking import report
from tam570.checking.changes import by_parameters, calls, keys
from tam570.checking.deadline import CALL, TooLong, limited
from tam570.checking.functions import Functions
from tam570.checking.mistakes import Mistake, candidates
from tam570.checking.outcomes import Outcomes
from tam570.course import Stub, contract, folder, stubs
from tam570.loading import Trouble, guarded_import, loaded, replaced, source_of
from tam570.notebooks import text_of
from tam570.progress import PASSED, Progress, kept, progress, remember

__all__ = ["check", "tested", "tests_of", "warm_up"]

OPTIONS = ("-p", "no:terminal", "--import-mode=importlib", "-p", "no:cacheprovider", "-c", os.devnull)
TRIALS = 5.0  # s, at most, for telling known mistakes
SLOW_IMPORT = (
    f"{{file}} takes longer than {CALL:g} s to import. Does it run a simulation by itself?\n"
    'Put that below `if __name__ == "__main__":`, so that it runs only when you start the file.'
)
Known = Mapping[str, tuple[str, str]]  # of each test what its outcome depends on, and the outcome


def check(file: Path, slug: str, log: str, *, changed: bool = False) -> bool:
    """Run the tests beside the file, else the released ones, on it; whether all pass.

    log     : a file in which to write which test runs
    changed : run only those whose outcome may have become another since they were run last
    """
    tests = tests_of(file, slug)
    released = stubs((folder(slug) / f"{slug}.py").read_bytes())
    if file.suffix == ".py" and (empty := _untouched(file, released)):
        report.untouched(slug, empty)
        remember(file, {}, progress(slug, {}, calls(tests.read_text(encoding="utf-8"), slug)))
        return False
    try:
        functions, skipped, printed = _functions(file, slug)
        now = _keys(file, tests, slug)
    except Trouble as trouble:
        report.trouble(slug, str(trouble))
        return False
    report.imported(skipped, printed)
    known = {test: was for test, was in kept(file).items() if was[0] == now.get(_function(test))} if changed else {}
    found = Outcomes(functions, tests, log, report.terminal())
    _run(tests, [name for name in now if name not in map(_function, known)], found, everything=not known)
    known |= {test: (now.get(_function(test), ""), outcome) for test, outcome in found.passed.items()}
    lasted = time.time() - file.stat().st_mtime
    since = f"      {len(found.passed)} tests run, {lasted:.2f} s after saving\n" if changed else ""
    return _reported(file, slug, known, found, released, since)


def _reported(file: Path, slug: str, known: Known, found: Outcomes, released: Mapping[str, Stub], since: str) -> bool:
    """Say and remember what became of the tests; whether all pass."""
    outcomes = {test: outcome for test, (_, outcome) in known.items()}
    used = by_parameters(calls(found.tests.read_text(encoding="utf-8"), slug), outcomes)
    causes = {test: one.function for test, one in found.failures.items() if one.function}
    come = progress(slug, outcomes, used, causes)
    remember(file, known, come)
    report.failures(found, _told(found, used, come, released))
    report.before([test for test, outcome in outcomes.items() if outcome != PASSED and test not in found.failures])
    report.progressed(slug, come, since)
    return not found.failures and all(one == PASSED for one in outcomes.values())


def tested(file: Path, slug: str, names: Sequence[str]) -> Outcomes:
    """What became of these tests on a file. Trouble if it cannot be tested."""
    functions, _, _ = _functions(file, slug)
    found = Outcomes(functions, tests_of(file, slug), os.devnull, None)
    _run(found.tests, names, found, everything=False)
    return found


def tests_of(file: Path, slug: str) -> Path:
    """The tests beside the file, else the released ones."""
    beside = file.parent / f"test_{slug}.py"
    return beside if beside.exists() else folder(slug) / beside.name


def _functions(file: Path, slug: str) -> tuple[Functions, list[str], str]:
    """The student's functions, the notebook's cells that were skipped, and what was printed. Trouble if none."""
    given = contract(slug)
    banned = given["off_limits"].get("*", ())
    guard = guarded_import(slug, banned, file.suffix == ".ipynb")
    with contextlib.redirect_stdout(io.StringIO()) as printed, replaced(banned, HERE):
        try:
            with limited():
                module, skipped = loaded(file, slug, {"__import__": guard})
        except TooLong:
            raise Trouble(SLOW_IMPORT.format(file=file.name)) from None
    functions = Functions(module, file, given["results"], given["off_limits"])
    if file.suffix == ".ipynb" and not any(hasattr(module, name) for name in given["results"]):
        raise Trouble(f"{file.name} defines none of the functions. Are they in {slug}.py?")
    sys.modules[slug] = functions.stand_in()
    return functions, skipped, printed.getvalue()


def _keys(file: Path, tests: Path, slug: str) -> dict[str, str]:
    """What the outcome of each test depends on. Trouble if the tests are not Python."""
    try:
        return keys(tests.read_text(encoding="utf-8"), text_of(source_of(file), file.suffix), slug)
    except SyntaxError as error:
        raise Trouble(f"{tests.name}, line {error.lineno}: SyntaxError: {error.msg}") from None


def _untouched(file: Path, released: Mapping[str, Stub]) -> list[str]:
    """The functions to be written, if all of them are and nothing is added; else nothing."""
    with contextlib.suppress(SyntaxError, ValueError):
        found = stubs(file.read_bytes())
        if {name: one.written for name, one in found.items()} == {name: one.written for name, one in released.items()}:
            return [name for name, one in released.items() if not one.written]
    return []


def _function(test: str) -> str:
    """The function of a test, without its parameters."""
    return test.partition("[")[0]


def _run(tests: Path, names: Sequence[str], found: Outcomes, *, everything: bool) -> None:
    """Run these tests."""
    if not names and not everything:
        print("Nothing has changed that a test sees.")
        return
    chosen = [str(tests)] if everything else [f"{tests}::{name}" for name in names]
    _pytest(tests.parent, chosen, [found])
    report.cleared(found.terminal)


def _pytest(root: Path, chosen: Sequence[str], plugins: Sequence[object]) -> None:
    """pytest by itself: plugins that happen to be installed take longer to load than the tests to run."""
    os.environ.setdefault("PYTEST_DISABLE_PLUGIN_AUTOLOAD", "1")
    pytest.main([*OPTIONS, f"--rootdir={root}", *chosen], plugins=plugins)


def warm_up() -> None:
    """Let pytest import all that it imports on its first run."""
    with tempfile.TemporaryDirectory() as empty, contextlib.redirect_stdout(io.StringIO()):
        _pytest(Path(empty), [empty], [])


def _told(
    found: Outcomes, used: Mapping[str, set[str]], come: Progress, released: Mapping[str, Stub]
) -> dict[str, str]:
    """For each failed test that a known mistake explains, which it is."""
    until, told = time.monotonic() + TRIALS, dict[str, str]()
    for name in come["missing"]:
        failed = [test for test, one in found.failures.items() if not one.function and name in used.get(test, ())]
        alone = [test for test, functions in used.items() if functions == {name} and found.passed.get(test) == PASSED]
        best: list[str] = []
        for mistake in candidates(name, released[name], found.functions.results[name]) if failed else ():
            if time.monotonic() > until:
                break
            mended = [test for test in failed if _passes(found, mistake, test)]
            if len(mended) > len(best) and all(_passes(found, mistake, test) for test in alone):
                best = mended
                told |= dict.fromkeys(mended, mistake.says)
    return told


def _passes(found: Outcomes, mistake: Mistake, test: str) -> bool:
    """Whether a test passes with this change."""
    import numpy as np

    found.functions.mistake = mistake
    try:
        with contextlib.redirect_stdout(None), np.errstate(all="ignore"), warnings.catch_warnings():
            warnings.simplefilter("ignore")
            found.again[test]()
    except (KeyboardInterrupt, GeneratorExit):
        raise
    except BaseException:  # whatever a student's code raises at numbers that were changed
        return False
    finally:
        found.functions.mistake = None
    return True
