"""Helps the notebook: shows what your module does, runs its tests, and lines what is missing instead of stopping."""

import contextlib
import json
import os
import subprocess
import sys
import traceback
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np

__all__ = ["animation", "shown", "tests"]

LARGEST_DRAWING = 420  # px
FRAMES = 300  # at most, in an animation
TESTS_TAKE = 120  # s, at most

PLAYER = """<canvas id="NAME" width="WIDTH" height="HEIGHT" role="img" aria-label="LABEL"></canvas>
<script>{const frames=FRAMES_, dt=DT, c=document.getElementById("NAME"), g=c.getContext("2d"); let start=null;
function draw(now){if(!c.isConnected)return; start??=now; const f=frames[Math.floor((now-start)/dt)%frames.length];
g.fillStyle="white";g.fillRect(0,0,c.width,c.height);g.lineWidth=2;g.strokeStyle="#1f4e8c";g.beginPath();
for(const [x,y,u,v] of f){g.moveTo(x,y);g.lineTo(u,v)} g.stroke();requestAnimationFrame(draw)}
requestAnimationFrame(draw)}</script>"""


@contextlib.contextmanager
def shown() -> Iterator[None]:
    """Run what is below; if your module cannot do it yet, say what is missing, and go on."""
    try:
        yield
    except Exception as error:
        print(_said(error))
    else:
        return
    if "matplotlib.pyplot" in sys.modules:
        sys.modules["matplotlib.pyplot"].close("all")


def animation(t: Any, wires: Any, label: str = "animation of the motion") -> Any:
    """Return the wires moving, drawn in the plane in real time; of three coordinates, y and z are seen, x a little.

    t     : (n,) s, evenly spaced
    wires : (n, k, 2, 2) or (n, k, 2, 3) line segments at these times
    """
    from IPython.display import HTML

    every = max(1, -(-len(t) // FRAMES))
    flat = _in_the_plane(np.asarray(wires, float))[::every]
    low, high = flat.min(axis=(0, 1, 2)), flat.max(axis=(0, 1, 2))
    scale = (LARGEST_DRAWING - 20) / max(float(np.max(high - low)), 1e-300)
    width, height = (high - low) * scale + 20
    pixels = np.stack([(flat[..., 0] - low[0]) * scale + 10, (high[1] - flat[..., 1]) * scale + 10], axis=-1)
    frames = np.round(pixels, 1).reshape(len(flat), -1, 4).tolist()
    values = {
        "NAME": f"lab{id(frames)}",
        "WIDTH": f"{width:.0f}",
        "HEIGHT": f"{height:.0f}",
        "LABEL": label,
        "DT": f"{1000 * every * float(t[1] - t[0]):.3g}",
        "FRAMES_": json.dumps(frames),
    }
    page = PLAYER
    for name, text in values.items():
        page = page.replace(name, text)
    return HTML(page)  # type: ignore[no-untyped-call]


def tests(*names: str, points: float, functions: Sequence[str] = ()) -> float:
    """Run these visible tests; the share of the points if the hidden tests went like them.

    Where there are no tests, it is said which of the functions are not written yet.
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
    """Return the functions of a module that only say that they are not written."""
    from tam570.course import stubs

    try:
        return {name for name, stub in stubs(module.read_bytes()).items() if not stub.written}
    except SyntaxError:
        return set()


def _said(error: Exception) -> str:
    """Return what is missing or wrong, and where in the student's module."""
    calls = traceback.extract_tb(error.__traceback__)
    of_file = [call for call in calls if Path(call.filename).name.startswith("hw")]
    if isinstance(error, NotImplementedError):
        return f"Nothing to see yet: {(of_file or list(calls))[-1].name} is not written."
    if isinstance(error, NameError) and not of_file:
        return f"Nothing to see yet: {error.name} comes from a cell above that shows nothing yet."
    where = f"in {of_file[-1].name}, line {of_file[-1].lineno}" if of_file else "with what your functions returned"
    return f"This stopped {where}: {type(error).__name__}: {error}"


def _in_the_plane(wires: Any) -> Any:
    """Oblique projection of three coordinates; two stay as they are."""
    if wires.shape[-1] == 2:
        return wires
    x, y, z = np.moveaxis(wires, -1, 0)
    return np.stack([y - 0.35 * x, z - 0.35 * x], axis=-1)


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
