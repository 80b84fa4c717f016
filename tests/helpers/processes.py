"""Other processes: what a fresh interpreter imports, and those below another one, by Linux's /proc."""

import contextlib
import subprocess
import sys
import time
from pathlib import Path

import pytest

__all__ = ["await_end", "children", "descendants", "imported_modules", "is_running"]


def imported_modules(code):
    """Return the top-level modules that a fresh interpreter has loaded after running the code."""
    text = f"import sys\n{code}\nprint(*{{name.partition('.')[0] for name in sys.modules}}, file=sys.stderr)"
    process = subprocess.run([sys.executable, "-c", text], capture_output=True, text=True, check=True)
    return set(process.stderr.split())


def children(pid):
    """Return the processes that the threads of a process have started."""
    actual = []
    for task in Path(f"/proc/{pid}/task").glob("*/children"):
        with contextlib.suppress(OSError):
            actual += map(int, task.read_text().split())
    return actual


def descendants(pid):
    return [item for child in children(pid) for item in (child, *descendants(child))]


def is_running(pid):
    with contextlib.suppress(OSError):
        return ") Z" not in Path(f"/proc/{pid}/stat").read_text()
    return False


def await_end(pids, seconds=60):
    """Fail if one of the processes is still there after so long."""
    deadline = time.monotonic() + seconds
    while any(map(is_running, pids)):
        if time.monotonic() > deadline:
            pytest.fail("a process outlives the one that started it")
        time.sleep(0.05)
