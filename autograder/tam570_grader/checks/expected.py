"""What is right at an input, computed a single time for a class that is given the same inputs.

What took long is left in a folder that the supervisors of a run share, as data: the others wait for it and read it.
"""

import contextlib
import fcntl
import hashlib
import os
import sys
import time
from collections.abc import Callable, Iterator
from contextvars import ContextVar
from pathlib import Path

import numpy as np

from tam570.values import Function, Numbers
from tam570_grader.checks.case import Case
from tam570_grader.checks.check import LruCache
from tam570_grader.protocol.wire import packed, unpacked

MOST_KNOWN = 3000  # answers; with inputs of its own for each student a run makes thousands
EXPENSIVE = 0.05  # s of processor time, from which an answer is shared

_known = LruCache[Numbers](MOST_KNOWN)
_place: ContextVar[Path | None] = ContextVar("place", default=None)  # the folder, while there is one
_expensive = set[str]()  # functions that have given a dear answer here; of the others nobody is asked


def expected_result(reference: Function, case: Case) -> Numbers:
    """right(*args, **kwargs) of a case; it is shared, and not to be changed."""
    inputs = case.packed

    def computed() -> Numbers:
        return shared(reference.__name__, _name(reference), inputs, lambda: reference(*case.args, **case.kwargs))

    return _known.value((reference, inputs), computed)


@contextlib.contextmanager
def sharing(folder: Path | None) -> Iterator[None]:
    """Share what is dear with the processes that name the same folder, which must be ours alone."""
    token = _place.set(folder)
    try:
        yield
    finally:
        _place.reset(token)


def shared(function: str, name: str, inputs: bytes, compute: Callable[[], Numbers]) -> Numbers:
    """Return what `compute` gives, from whoever computed it first where that took long.

    function : whose other answers are likely to be as dear
    name     : tells the computation from all others; "" where that cannot be
    """
    folder = _place.get()
    if not name or not folder:
        return compute()
    digest = hashlib.sha256(name.encode() + b"\0" + inputs).hexdigest()
    path, expensive = folder / digest, function in _expensive
    with _only_one(folder / digest[:3]) if expensive else contextlib.nullcontext():
        if expensive and path.exists():
            value = unpacked(path.read_bytes())
            return tuple(part.copy() for part in value["parts"]) if isinstance(value, dict) else value.copy()
        began = time.thread_time()
        value = compute()
        if time.thread_time() - began > EXPENSIVE and _is_data(value):
            _expensive.add(function)
            _keep(path, value)
    return value


def _keep(path: Path, value: object) -> None:
    """Leave a value where the others look; a full disk costs them the time to compute it."""
    with contextlib.suppress(OSError):
        draft = path.with_suffix(f".{os.getpid()}")
        draft.write_bytes(packed({"parts": [*value]} if isinstance(value, tuple) else value))
        draft.rename(path)


def _name(reference: Function) -> str:
    """Return a function's, if the module holds it by this name: a closure may be another in the next process."""
    module, name = reference.__module__, getattr(reference, "__qualname__", "")
    return f"{module}.{name}" if getattr(sys.modules.get(module), name, None) is reference else ""


@contextlib.contextmanager
def _only_one(path: Path) -> Iterator[None]:
    """One process at a time computes; those that need the same answer wait for it."""
    with open(path, "ab") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        yield


def _is_data(value: object) -> bool:
    parts = value if type(value) is tuple else (value,)
    return all(type(part) is np.ndarray and part.dtype == np.float64 for part in parts)
