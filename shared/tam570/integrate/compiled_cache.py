"""Cache of compiled runs, for calls of `solve` that differ only in the start."""

from collections.abc import Callable
from functools import partial

import numpy as np

from tam570.integrate.adaptive import Control, of_steps, start_run
from tam570.integrate.arguments import Array
from tam570.integrate.cache_key import Changeable, cache_slot, call_key
from tam570.integrate.engine import Engine
from tam570.integrate.watch import COMPILED, available
from tam570.values import Numbers, Parameters

CompiledRun = Callable[[Numbers], Array | None]
Slot = list[CompiledRun]  # empty at first; its last item is the run to try

METHODS = ("auto", "compiled")  # methods whose runs are cached
LARGEST = 20_000  # numbers in the result of a run that is cached, at most


def compile_run(engine: Engine, times: Array, control: Control) -> CompiledRun:
    """Return run(y0) -> (n, k) states at `times` by Taylor's method, or None if that is impossible or fails."""
    begin, end = float(times[0]), float(times[-1])
    if engine.graph is None or not available() or engine.next_break(begin, begin, end) != end:
        return _nothing
    run = start_run(engine, times, np.zeros(engine.formulas.size), of_steps(engine, control))
    try:
        from tam570.integrate.compiled import backend

        runs = backend.taylor_repeated(run, partial(run.watch, COMPILED))
    except (ImportError, OSError, RuntimeError):  # llvmlite is broken: `solve` continues in Python
        runs = None
    return runs or _nothing


def slot_of(
    method: str, rhs: Numbers, t: Numbers, y0: Numbers, parameters: Parameters | None, rtol: float, atol: Numbers
) -> Slot | None:
    """Return the cache slot of runs with these arguments, or None if there is none.

    There is none if `method` is not cached, or if arguments are invalid or may change unnoticed.
    """
    if method not in METHODS:
        return None
    try:
        key = call_key(rhs, parameters)
        if not isinstance(t, tuple):
            times = np.asarray(t, dtype=float)
            t = times.shape, times.tobytes()
        # "auto" depends on the start; a complex one raises TypeError
        start = len(y0) if method == "compiled" else np.asarray(y0).astype(float, casting="same_kind").tobytes()
        return cache_slot((key, start, t, rtol, atol))
    except (Changeable, TypeError, ValueError, OverflowError):
        return None


def keep(slot: Slot, engine: Engine, times: Array, control: Control) -> None:
    """Note that a compiled run was needed; at the second time, compile one for later calls unless it is large."""
    if not slot:
        slot.append(_nothing)
    elif len(slot) == 1 and len(times) * engine.formulas.size <= LARGEST:
        slot.append(compile_run(engine, times, control))


def _nothing(y0: Numbers) -> None:
    return None
