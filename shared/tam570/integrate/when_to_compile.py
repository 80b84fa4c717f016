"""A loop in Python that goes on compiled where that is installed and gets there sooner, compilation included."""

import sys
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

__all__ = ["Loop", "carried_through"]

PROBE = 50  # steps before the clock is read for the first time
SOONEST = 0.05  # s, in which no compiled code was ever loaded
SOONEST_COLD = 0.5  # s, the same where numba is not imported yet; asking more closely costs imports too


@dataclass(frozen=True)
class Loop:
    """A loop over the steps of one run.

    run    : run(function, state, steps at most, compiled) -> state
    share  : share(state), the part of the run that is done, 1 at its end
    python : the function in Python
    entry  : its name in `source`
    source : gives the module to compile; None where there is none
    compile_cost : how many times as long its source takes to compile as one of a step of DOP853 that is as long
    """

    run: Callable[[Callable[..., Any], Any, int, bool], Any]
    share: Callable[[Any], float]
    python: Callable[..., Any]
    entry: str
    source: Callable[[], str] | None
    compile_cost: float = 1.0


def carried_through(loop: Loop, state: Any, how: str) -> Any:
    """The state at the end of the run; how: "python" and "numba" insist, "auto" takes what is sooner."""
    if how == "numba" and loop.source is None:
        raise ValueError('method: "numba" needs an rhs without branches or conversions, and no project; try "auto"')
    if how == "python" or loop.source is None:
        return loop.run(loop.python, state, 2**62, False)
    if how == "numba":
        return _compiled(loop, loop.source, state)
    state = _until_it_repays(loop, loop.source, state)
    if loop.share(state) >= 1:
        return state
    try:
        return _compiled(loop, loop.source, state)
    except Exception:  # a broken numba, a folder not to be written: nobody asked for it
        return loop.run(loop.python, state, 2**62, False)


def _compiled(loop: Loop, source: Callable[[], str], state: Any) -> Any:
    from tam570.integrate import numba_backend

    return loop.run(numba_backend.loaded(source(), loop.entry), state, 2**62, True)


def _until_it_repays(loop: Loop, source: Callable[[], str], state: Any) -> Any:
    """Steps in Python until the end, or until what is left takes longer than loading the compiled loop."""
    if "numba" in sys.modules and _loaded_already(source()):
        return state
    soonest = SOONEST if "numba" in sys.modules else SOONEST_COLD
    passed, budget, wait = 0.0, PROBE, 0.0
    while True:
        began = time.perf_counter()
        state = loop.run(loop.python, state, budget, False)
        passed += time.perf_counter() - began
        done = loop.share(state)
        if done >= 1:
            return state
        left = passed * (1 / done - 1) if done else 0.0
        if left > soonest:  # else not worth the question
            wait = wait or _wait(source(), loop.compile_cost)
            if left > wait:
                return state
        budget *= 2


def _loaded_already(source: str) -> bool:
    from tam570.integrate import numba_backend

    return numba_backend.loaded_already(source)


def _wait(source: str, compile_cost: float) -> float:
    from tam570.integrate import numba_backend

    return numba_backend.wait(source, compile_cost)
