"""A notice at the terminal about work that takes long, and a time limit."""

import _thread
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager

NOTICE, GLANCE = 2.0, 0.2  # s until the notice; between checks of the clock


@contextmanager
def patience(what: str, most: float | None = None) -> Iterator[None]:
    """Print a notice at the terminal if a block still runs after two seconds; limit its processor time.

    Parameters
    ----------
    what : str
        The work, for the notice.
    most : float, optional
        s of processor time, after which the block ends; only in the main thread, as no other can be interrupted.

    Raises
    ------
    ValueError
        If the block takes longer than `most`.
    """
    done, late, before = threading.Event(), threading.Event(), time.process_time()
    ends = most is not None and threading.current_thread() is threading.main_thread()

    def watch() -> None:
        if done.wait(NOTICE):
            return
        if sys.stderr.isatty():
            print(f"tam570: {what} takes a while; Ctrl-C ends it", file=sys.stderr, flush=True)
        while ends and not done.wait(GLANCE):
            if time.process_time() - before > (most or 0.0):
                late.set()
                return _thread.interrupt_main()

    threading.Thread(target=watch, daemon=True).start()
    try:
        yield
    except KeyboardInterrupt:
        if not late.is_set():
            raise
        raise ValueError(f"{what} takes longer than {most:g} s: choose slower numbers, or fewer seconds") from None
    finally:
        done.set()
