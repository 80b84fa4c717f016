"""What the grader itself may spend on one submission: processor time and memory, of the thread that grades it.

A submission chooses what is compared, so it chooses how long that takes. Where it takes too much, the submission ends
like one that has used its own time, and the class is graded on.
"""

import ctypes
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from tam570_grader.sandbox.student import BudgetSpent

__all__ = ["MEMORY", "SECONDS", "budget"]

SECONDS = 60.0  # of processor time; an honest submission takes about one
MEMORY = 2**31  # bytes, besides what is there before; a reply of 64 MiB is held a few times
GLANCE = 0.25  # s between two looks at the clock
SIZE = Path("/proc/self/statm")  # in pages
LIMIT = threading.Lock()  # held by the thread that has set the process's limit of memory


class _Overdue(BudgetSpent):
    def __init__(self) -> None:
        super().__init__("to judge what it returned took the grader too much processor time")


@contextmanager
def budget(seconds: float = SECONDS, memory: int = MEMORY) -> Iterator[None]:
    """Raise BudgetSpent in this block, at its next step in Python, when this thread has spent so much in it.

    The limit of memory is the process's: of blocks in several threads at a time, the first sets it.
    """
    thread, clock, done = threading.get_ident(), _clock(), threading.Event()
    watch = threading.Thread(target=_watch, args=(thread, clock, clock() + seconds, done), daemon=True)
    watch.start()
    try:
        with _limited(memory):
            yield
    except MemoryError:
        raise BudgetSpent("to judge what it returned took the grader too much memory") from None
    finally:
        _ended(watch, done)
        _raise_in(thread, None)  # what has not arrived yet does not


def _ended(watch: threading.Thread, done: threading.Event) -> None:
    """End the watch, even where it speaks in this very moment."""
    while watch.is_alive():
        with suppress(_Overdue):
            done.set()
            watch.join()


def _watch(thread: int, clock: Callable[[], float], end: float, done: threading.Event) -> None:
    """Raise _Overdue in the thread while it is beyond the end: a block that swallows it is told again."""
    while not done.wait(GLANCE):
        if clock() > end:
            _raise_in(thread, _Overdue)


def _raise_in(thread: int, kind: type[BudgetSpent] | None) -> None:
    ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(thread), kind and ctypes.py_object(kind))


def _clock() -> Callable[[], float]:
    """The processor time of this thread, for any other; that of the whole process where threads have none."""
    if not hasattr(time, "pthread_getcpuclockid"):
        return time.process_time
    number = time.pthread_getcpuclockid(threading.get_ident())
    return lambda: time.clock_gettime(number)


@contextmanager
def _limited(memory: int) -> Iterator[None]:
    """No more than so many bytes besides those that are there, where the system tells and keeps that."""
    if not SIZE.exists() or not LIMIT.acquire(blocking=False):
        yield
        return
    import resource

    before = resource.getrlimit(resource.RLIMIT_AS)
    most = int(SIZE.read_text().split()[0]) * resource.getpagesize() + memory
    limits = [limit for limit in (most, *before) if limit != resource.RLIM_INFINITY]
    try:
        resource.setrlimit(resource.RLIMIT_AS, (min(limits), before[1]))
        yield
    finally:
        with suppress(ValueError, OSError):
            resource.setrlimit(resource.RLIMIT_AS, before)
        LIMIT.release()
