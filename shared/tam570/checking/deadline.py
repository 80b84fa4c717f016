"""Ends code of a student's that takes longer than the grader gives it, on every system and without losing the tests.

A thread watches the clock and interrupts the main one; code that cannot be interrupted is ended with the process.
"""

import _thread
import faulthandler
import os
import signal
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass

# s of processor time, a call or the import, as the grader has it; adjustable, as it is there
CALL = float(os.environ.get("TAM570_CALL_LIMIT", "10"))
CPU = 60.0  # s of processor time that the grader gives all calls of a file together
PATIENCE = 6  # a call may last this many times as long where the machine is busy
ASLEEP = 0.02  # of a core: a call that uses less for so long as its limit is asleep
GRACE = 5.0  # s, in which an interrupted call must end
GLANCE = 0.05  # s between two looks
STUCK = CALL + GRACE  # s in which no other thread may run: C code that never comes back, for example
HUNG = 97  # the exit code where it did not


class TooLong(BaseException):
    """A call has used up its time. No `except Exception` of a student's catches it."""


@dataclass
class _Running:
    """The call that is running, if one is."""

    since: float | None = None  # s, on the wall's clock
    used: float = 0.0  # s of processor time before it
    limit: float = CALL
    ended: float | None = None  # s, when it was told to end


_now = _Running()


def start(hung: str = os.devnull) -> None:
    """Begin to watch; once in a process, from its main thread.

    hung : a file that is no longer empty after code that cannot be interrupted has ended the process
    """
    signal.signal(signal.SIGINT, _interrupted)
    threading.Thread(target=_watch, args=(hung,), daemon=True).start()


@contextmanager
def limited(limit: float = CALL) -> Iterator[None]:
    """Limit a block: it may take `limit` seconds of processor time; then TooLong is raised in it."""
    _now.since, _now.used, _now.limit, _now.ended = time.monotonic(), time.process_time(), limit, None
    try:
        yield
    finally:
        _now.since = _now.ended = None


def _interrupted(number: int, frame: object) -> None:
    if _now.ended is not None:  # else it comes too late; Ctrl-C is for the process that waits for this one
        raise TooLong


def _watch(hung: str) -> None:
    file = open(hung, "w")  # noqa: SIM115  for what is said at the very end
    parent = os.getppid()
    while True:
        faulthandler.dump_traceback_later(STUCK, exit=True, file=file)
        time.sleep(GLANCE)
        if os.getppid() != parent:  # who waits for this process has gone
            os._exit(HUNG)
        since, ended = _now.since, _now.ended
        if since is None:
            continue
        if ended is not None and time.monotonic() - ended > GRACE:
            print("hung", file=file, flush=True)
            os._exit(HUNG)
        if ended is not None or _over(since):  # again and again: a bare `except:` may have caught the first
            _now.ended = ended or time.monotonic()
            if hasattr(signal, "pthread_kill"):  # wakes a sleeping one too
                signal.pthread_kill(threading.main_thread().ident or 0, signal.SIGINT)
            else:
                _thread.interrupt_main()


def _over(since: float) -> bool:
    lasted, used = time.monotonic() - since, time.process_time() - _now.used
    return used > _now.limit or lasted > _now.limit and (used < ASLEEP * lasted or lasted > PATIENCE * _now.limit)
