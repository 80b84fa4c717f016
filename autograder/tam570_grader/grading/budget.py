"""What the grader itself may spend on one check: steps of hidden code, which are counted, and memory.

A submission chooses what is compared. Where that takes too much, the check fails, and the next ones run.
"""

import resource
import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress

from tam570.meter import limited
from tam570_grader.protocol.jail import address_space

STEPS = 20_000_000  # of a check, and of the search for what is wrong; an honest submission takes a hundredth
MEMORY = 2**31  # bytes, besides what is there before; a reply of 64 MiB is held a few times
LIMIT = threading.Lock()  # held by the thread that has set the process's limit of memory


@contextmanager
def budget(steps: int = STEPS, memory: int = MEMORY) -> Iterator[None]:
    """Raise Exhausted in this block when it has spent so many steps, MemoryError when it needs more memory.

    The limit of memory is the process's: of blocks in several threads at a time, the first sets it.
    """
    with limited(steps), _limited_memory(memory):
        yield


@contextmanager
def _limited_memory(memory: int) -> Iterator[None]:
    """No more than so many bytes besides those that are there, where the system tells and keeps that."""
    used = address_space()
    if not used or not LIMIT.acquire(blocking=False):
        yield
        return
    before = resource.getrlimit(resource.RLIMIT_AS)
    limits = [limit for limit in (used + memory, *before) if limit != resource.RLIM_INFINITY]
    try:
        resource.setrlimit(resource.RLIMIT_AS, (min(limits), before[1]))
        yield
    finally:
        with suppress(ValueError, OSError):
            resource.setrlimit(resource.RLIMIT_AS, before)
        LIMIT.release()
