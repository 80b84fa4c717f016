"""Helpers of the notebook: show what your module does, run its tests, and print what is missing instead of stopping."""

import contextlib
import os
import subprocess
import sys
import traceback
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np

__all__ = ["animation", "shown", "tests"]

HEIGHT = 480  # px, height of an animation
TESTS_TAKE = 120  # s, time limit of the tests


@contextlib.contextmanager
def shown() -> Iterator[None]:
    """Run the block below; if it raises, print what your module lacks and go on."""
    try:
        yield
    except Exception as error:
        print(_said(error))
    else:
        return
    if "matplotlib.pyplot" in sys.modules:
        sys.modules["matplotlib.pyplot"].close("all")


def animation(t: Any, wires: Any, label: str = "animation of the motion") -> Any:
    """Return an animation of moving wires; drag to turn the view if they have three coordinates.

    t     : (n,) times, s, evenly spaced
    wires : (n, k, 2, 2) or (n, k, 2, 3) k line segments at these times, each from one point to another
    """
    from tam570.show import Shown
    from tam570.show.scene import Panel, Scene, Shape

    ends = np.asarray(wires, float)
    if not np.isfinite(ends).all():
        raise ValueError("not all of the wires' numbers are finite")
    points = ends.reshape(len(ends), -1, ends.shape[-1])
    return Shown(Scene(label, label, np.asarray(t, float), [Panel([Shape("lines", points, 0)])]), height=HEIGHT)


def tests(*names: str, points: float, functions: Sequence[str] = ()) -> float:
    """Run these visible tests; return the points that the hidden tests would give for the same share of passes.

    Without tests, print which of the functions are not written yet.
    """
    file = next(Path().glob("test_hw*.py"))
    if not names:
        missing = [name for name in functions if name in _unwritten(Path(file.name.removeprefix("test_")))]
        lines = [f"- {name} is not written yet" for name in missing] or ["No visible tests here: check it yourself."]
        print("\n".join(lines))
        return 0.0 if missing else points
    command = [sys.executable, "-B", __file__, *names]
    environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}
    try:
        run = subprocess.run(command, capture_output=True, text=True, timeout=TESTS_TAKE, env=environment)
    except subprocess.TimeoutExpired:
        print(f"The tests took longer than {TESTS_TAKE} s: is there a loop without an end?")
        return 0.0
    *lines, last = run.stdout.splitlines() or [""]
    if run.returncode or not last.startswith("of "):
        print(f"The tests could not be run:\n{(run.stdout + run.stderr)[-2000:]}")
        return 0.0
    _, passed, total = last.split()
    print("\n".join(lines))
    print(f"{passed} of {total} visible tests pass. Your points come from other tests, with other numbers.")
    return points * int(passed) / int(total)


def _unwritten(module: Path) -> set[str]:
    """Return the functions of a module that are still the stub's; none if it has a syntax error."""
    from tam570.course import stubs

    try:
        return {name for name, stub in stubs(module.read_bytes()).items() if not stub.written}
    except SyntaxError:
        return set()


def _said(error: Exception) -> str:
    """Return a sentence on what is missing or wrong, and where in the student's module."""
    calls = traceback.extract_tb(error.__traceback__)
    of_file = [call for call in calls if Path(call.filename).name.startswith("hw")]
    if isinstance(error, NotImplementedError):
        return f"Nothing to see yet: {(of_file or list(calls))[-1].name} is not written."
    if isinstance(error, NameError) and not of_file:
        return f"Nothing to see yet: {error.name} comes from a cell above that shows nothing yet."
    where = f"in {of_file[-1].name}, line {of_file[-1].lineno}" if of_file else "with what your functions returned"
    return f"This stopped {where}: {type(error).__name__}: {error}"


def _main(names: list[str]) -> int:
    from tam570.checking import deadline
    from tam570.checking.session import run_tests
    from tam570.loading import Trouble

    deadline.start()
    module = next(Path().glob("test_hw*.py")).name.removeprefix("test_")
    try:
        session = run_tests(Path(module).resolve(), Path(module).stem, names)
    except Trouble as trouble:
        print(trouble)
        return 1
    for name in session.passed:
        failure = session.failures.get(name)
        why = f": {failure.message.strip().splitlines()[0]}" if failure else ""
        print(f"{'-' if failure else '+'} {name.removeprefix('test_').replace('_', ' ')}{why}")
    print(f"of {sum(outcome == 'passed' for outcome in session.passed.values())} {len(session.passed)}")
    return 0


if __name__ == "__main__":
    sys.exit(_main(sys.argv[1:]))
