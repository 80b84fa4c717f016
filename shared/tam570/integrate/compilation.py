"""A loop in Python that goes on in compiled code where that gets there sooner, compilation included."""

import importlib.util
import os
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

__all__ = ["Loop", "available", "run_with_compilation", "seconds_until_compiled"]

PROBE = 50  # steps before the clock is read for the first time
SOONEST = 0.02  # s, in which nothing was ever compiled; asking more closely costs time too
IMPORT = 0.06  # s, of llvmlite
COMPILE, AN_OPERATION = 0.05, 0.0015  # s, and for each operation of a right-hand side


@dataclass(frozen=True)
class Loop:
    """A loop over the steps of one run.

    python   : python(state, steps at most) -> state
    share    : share(state), the part of the run that is done, 1 at its end
    compiled : compiled(state) -> state at the end; None where there is none
    wait     : wait(), s until that could start; nothing where this process has it already
    """

    python: Callable[[Any, int], Any]
    share: Callable[[Any], float]
    compiled: Callable[[Any], Any] | None = None
    wait: Callable[[], float] = float


def run_with_compilation(loop: Loop, state: Any, how: str) -> Any:
    """The state at the end of the run; how: "python" and "compiled" insist, "auto" takes what is sooner."""
    if how == "compiled" and loop.compiled is None:
        raise ValueError('method: "compiled" needs an rhs without branches or conversions, and no project; try "auto"')
    if how == "python" or loop.compiled is None:
        return loop.python(state, 2**62)
    if how == "compiled":
        return loop.compiled(state)
    state = _until_it_repays(loop, state)
    if loop.share(state) >= 1:
        return state
    try:
        return loop.compiled(state)
    except (ImportError, OSError, RuntimeError):  # a broken llvmlite: nobody asked for it
        return loop.python(state, 2**62)


def _until_it_repays(loop: Loop, state: Any) -> Any:
    """Steps in Python until the end, or until what is left takes longer than the compiled loop takes to start."""
    wait = loop.wait() if "llvmlite" in sys.modules else None
    passed, budget = 0.0, PROBE
    while wait != 0.0:
        began = time.perf_counter()
        state = loop.python(state, budget)
        passed += time.perf_counter() - began
        done = loop.share(state)
        if done >= 1:
            return state
        left = passed * (1 / done - 1) if done else 0.0
        if left > SOONEST:
            wait = loop.wait() if wait is None else wait
            if left > wait:
                return state
        budget *= 2
    return state


def available() -> bool:
    """Whether llvmlite is installed, and not forbidden by TAM570_COMPILED=0; it is not imported for that."""
    return os.environ.get("TAM570_COMPILED") != "0" and importlib.util.find_spec("llvmlite") is not None


def seconds_until_compiled(operations: float) -> float:
    """About how long until compiled code could start; infinite without llvmlite."""
    if not available():
        return float("inf")
    return COMPILE + AN_OPERATION * operations + (0.0 if "llvmlite" in sys.modules else IMPORT)
