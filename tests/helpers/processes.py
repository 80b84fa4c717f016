"""Other processes: the modules that a new interpreter imports, and the descendants of a process."""

import contextlib
import subprocess
import sys
import time

import psutil


def imported_modules(code):
    """Return the names of the modules that a new interpreter has loaded after it ran the code."""
    text = f"import sys\n{code}\nprint(*sys.modules, file=sys.stderr)"
    process = subprocess.run([sys.executable, "-c", text], capture_output=True, text=True, check=True)
    return set(process.stderr.split())


def descendants(pid):
    """Return the child processes of a process, and theirs, recursively."""
    return psutil.Process(pid).children(recursive=True)


def is_running(process):
    with contextlib.suppress(psutil.NoSuchProcess):
        return process.status() != psutil.STATUS_ZOMBIE
    return False


def await_end(processes, seconds=60):
    """Fail if one of the processes is still running after so many seconds."""
    deadline = time.monotonic() + seconds
    while any(map(is_running, processes)):
        assert time.monotonic() < deadline, "a process outlives the one that started it"
        time.sleep(0.05)
