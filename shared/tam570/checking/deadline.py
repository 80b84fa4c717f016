"""End a student's code that exceeds the grader's time limit, on every system and without ending the tests.

A thread watches the clock and interrupts the main thread; if the code cannot be interrupted, it ends the process.
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

# s of processor time for a call or the import, as in the grader; adjustable, as it is there
CALL = float(os.environ.get("TAM570_CALL_LIMIT", "10"))
CPU = 60.0  # s of processor time that the grader allows for all calls of a file together
PATIENCE = 6  # times its limit: how long a call may last on a busy machine
ASLEEP = 0.02  # of a core: a call that lasts longer than its limit and uses less is asleep
GRACE = 5.0  # s in which an interrupted call must end
GLANCE = 0.05  # s between checks of the clock
STUCK = CALL + GRACE  # s after which a process ends if no other thread can run, as in C code that never returns
HUNG = 97  # exit code of a process that could not be interrupted


class TooLong(BaseException):
    """A call has used up its time. A student's `except Exception` does not catch it."""


@dataclass
class _Running:
    """The call that is running, if any."""

    since: float | None = None  # s, of time.monotonic
    used: float = 0.0  # s of processor time before the call
    limit: float = CALL
    ended: float | None = None  # s, when it was first interrupted


_now = _Running()


def start(hung: str = os.devnull) -> None:
    """Start the thread that watches the clock; once in a process, from its main thread.

    hung : a file, written to if the process ends because code could not be interrupted
    """
    signal.signal(signal.SIGINT, _interrupted)
    threading.Thread(target=_watch, args=(hung,), daemon=True).start()


@contextmanager
def limited(limit: float = CALL) -> Iterator[None]:
    """Raise TooLong in this block after `limit` seconds of processor time."""
    _now.since, _now.used, _now.limit, _now.ended = time.monotonic(), time.process_time(), limit, None
    try:
        yield
    finally:
        _now.since = _now.ended = None


def _interrupted(number: int, frame: object) -> None:
    if _now.ended is not None:  # else the call has ended, or Ctrl-C was meant for the parent
        raise TooLong


def _watch(hung: str) -> None:
    file = open(hung, "w")  # noqa: SIM115  open until the process ends
    parent = os.getppid()
    while True:
        faulthandler.dump_traceback_later(STUCK, exit=True, file=file)
        time.sleep(GLANCE)
        if os.getppid() != parent:  # the parent process has ended
            os._exit(HUNG)
        since, ended = _now.since, _now.ended
        if since is None:
            continue
        if ended is not None and time.monotonic() - ended > GRACE:
            print("hung", file=file, flush=True)
            os._exit(HUNG)
        if ended is not None or _over(since):  # repeatedly: a bare `except:` may have caught the first
            _now.ended = ended or time.monotonic()
            if hasattr(signal, "pthread_kill"):  # also wakes a sleeping thread
                signal.pthread_kill(threading.main_thread().ident or 0, signal.SIGINT)
            else:
                _thread.interrupt_main()


def _over(since: float) -> bool:
    lasted, used = time.monotonic() - since, time.process_time() - _now.used
    return used > _now.limit or lasted > _now.limit and (used < ASLEEP * lasted or lasted > PATIENCE * _now.limit)
