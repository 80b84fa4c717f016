"""Limits on what the grader itself spends on one check: counted steps of hidden code, and memory.

A submission determines what is compared. If the comparison takes too much, the check fails and the next ones run.
"""

import resource
import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress

from tam570.meter import limited
from tam570_grader.protocol.jail import address_space

STEPS = 20_000_000  # per check, and again for its diagnosis; an honest submission needs a hundredth
MEMORY = 2**31  # bytes beyond those in use before; several copies of a 64 MiB reply exist at a time
LIMIT = threading.Lock()  # locked while the process's memory limit is lowered


@contextmanager
def budget(steps: int = STEPS, memory: int = MEMORY) -> Iterator[None]:
    """Raise Exhausted in this block after this many steps, MemoryError if it needs more memory (in bytes).

    The memory limit holds for the process: if blocks overlap in several threads, only the first sets it.
    """
    with limited(steps), _limited_memory(memory):
        yield


@contextmanager
def _limited_memory(memory: int) -> Iterator[None]:
    """Limit the memory that the block allocates, in bytes; no limit where the system cannot report or enforce it."""
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
