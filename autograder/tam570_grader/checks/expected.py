"""Expected results, computed once for all students who have the same inputs.

Results that take long are also stored in a folder that the supervisors of a run share: the others wait and read them.
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

MOST_KNOWN = 3000  # results in the cache; if inputs differ by student, a run makes thousands
EXPENSIVE = 0.05  # s of CPU time; results that take longer are shared

_known = LruCache[Numbers](MOST_KNOWN)
_place: ContextVar[Path | None] = ContextVar("place", default=None)  # the shared folder, if there is one
_expensive = set[str]()  # functions with an expensive result so far; only their results are looked up


def expected_result(reference: Function, case: Case) -> Numbers:
    """Return the reference's result for a case; callers share it and must not change it."""
    inputs = case.packed

    def computed() -> Numbers:
        return shared(reference.__name__, _name(reference), inputs, lambda: reference(*case.args, **case.kwargs))

    return _known.value((reference, inputs), computed)


@contextlib.contextmanager
def sharing(folder: Path | None) -> Iterator[None]:
    """Share expensive results with the processes that use the same folder, to which nobody else may have access."""
    token = _place.set(folder)
    try:
        yield
    finally:
        _place.reset(token)


def shared(function: str, name: str, inputs: bytes, compute: Callable[[], Numbers]) -> Numbers:
    """Return the result of `compute`, or that of the process that computed it first if it took long.

    function : if a result of it was expensive, the others are expected to be, and are looked up
    name     : identifies the computation; "" if that is impossible: nothing is shared then
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
            with contextlib.suppress(OSError):  # if the disk is full, the other processes compute it themselves
                draft = path.with_suffix(f".{os.getpid()}")
                draft.write_bytes(packed({"parts": [*value]} if isinstance(value, tuple) else value))
                draft.rename(path)
    return value


def _name(reference: Function) -> str:
    """Return a function's module and name; "" for a closure, which may be another function in the next process."""
    module, name = reference.__module__, getattr(reference, "__qualname__", "")
    return f"{module}.{name}" if getattr(sys.modules.get(module), name, None) is reference else ""


@contextlib.contextmanager
def _only_one(path: Path) -> Iterator[None]:
    """Lock the file, so that processes that need the same result wait for the one that computes it."""
    with open(path, "ab") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        yield


def _is_data(value: object) -> bool:
    parts = value if type(value) is tuple else (value,)
    return all(type(part) is np.ndarray and part.dtype == np.float64 for part in parts)
