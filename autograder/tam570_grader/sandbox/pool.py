"""The zygotes of this process, one for each thread, what it imports, may use and sees; one that dies is replaced."""

import threading
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeVar

from tam570_grader.sandbox.launch import command
from tam570_grader.sandbox.zygote import ResourceLimits, Zygote, ZygoteLost

TRIES = 3  # zygotes, or supervisors, that a submission may see die under it before we give up
MOST = 12  # zygotes of a thread that are kept
T = TypeVar("T")
_warm: dict[tuple[Any, ...], Zygote] = {}


@dataclass(frozen=True)
class Attempt:
    """One try of a submission.

    forgiving : another one follows: ZygoteLost where the submission is killed from outside, as for want of memory
    is_retry     : one went before: the submission may know hidden inputs, and what it says at import is not quoted
    """

    forgiving: bool = False
    is_retry: bool = False


ONLY = Attempt()
ATTEMPTS = tuple(Attempt(forgiving=number < TRIES, is_retry=number > 1) for number in range(1, TRIES + 1))


def tried(
    work: Callable[[Zygote, Attempt], T], preload: Sequence[str], limits: ResourceLimits, hidden: Sequence[Path] = ()
) -> T:
    """work(zygote, attempt) on a warm zygote, on another where that one is lost; ZygoteLost from the last attempt."""
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
    """Start a zygote where none is warm, without waiting for it; the key of the warm one."""
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
    """End the zygotes of this process."""
    try:
        yield
    finally:
        while _warm:
            _warm.popitem()[1].close()
