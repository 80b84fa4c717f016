"""The zygotes of this process, one for each combination of thread, imports, limits and hidden folders."""

import threading
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeVar

from tam570_grader.sandbox.launch import command
from tam570_grader.sandbox.zygote import ResourceLimits, Zygote, ZygoteLost

TRIES = 3  # attempts to grade a submission when zygotes or supervisors die
MOST = 12  # most zygotes per thread
T = TypeVar("T")
_warm: dict[tuple[Any, ...], Zygote] = {}


@dataclass(frozen=True)
class Attempt:
    """An attempt to grade a submission.

    forgiving : another attempt can follow, so raise ZygoteLost if the submission is killed from outside (no memory)
    is_retry  : the submission may know hidden inputs from an earlier attempt, so do not quote its errors at import
    """

    forgiving: bool = False
    is_retry: bool = False


ONLY = Attempt()
ATTEMPTS = tuple(Attempt(forgiving=number < TRIES, is_retry=number > 1) for number in range(1, TRIES + 1))


def tried(
    work: Callable[[Zygote, Attempt], T], preload: Sequence[str], limits: ResourceLimits, hidden: Sequence[Path] = ()
) -> T:
    """Return work(zygote, attempt) with a warm zygote; on ZygoteLost, retry with a new zygote, up to TRIES times."""
    for attempt in ATTEMPTS:
        key = start(preload, limits, hidden)
        try:
            return work(_warm[key], attempt)
        except ZygoteLost:
            _warm.pop(key).close()
            if not attempt.forgiving:
                raise
    raise AssertionError("the last try returns or raises")


def start(preload: Sequence[str], limits: ResourceLimits, hidden: Sequence[Path] = ()) -> tuple[Any, ...]:
    """Start a zygote unless there is a warm one, without waiting for it; return its key."""
    key = (threading.get_ident(), *preload, limits, *command(tuple(hidden)))
    if key not in _warm:
        mine = [other for other in _warm if other[0] == key[0]]
        for other in mine[: len(mine) + 1 - MOST]:
            _warm.pop(other).close()
        _warm[key] = Zygote(preload, limits, hidden)
    return key


def zygote(preload: Sequence[str], limits: ResourceLimits, hidden: Sequence[Path] = ()) -> Zygote:
    """Return a warm zygote, which may still be starting."""
    return _warm[start(preload, limits, hidden)]


@contextmanager
def sandboxes() -> Iterator[None]:
    """Close all zygotes of this process at the end of the block."""
    try:
        yield
    finally:
        while _warm:
            _warm.popitem()[1].close()
