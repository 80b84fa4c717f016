"""Runs of order 8 with automatic steps."""

import math
from collections.abc import Callable, Sequence
from functools import lru_cache, partial
from typing import Any

import numpy as np

from tam570.integrate.adaptive_loop import LACKS_SCALE, LARGEST, NOT_FINITE, RUNNING, TOO_SHORT, State, loop_with
from tam570.integrate.arguments import Array
from tam570.integrate.binding import check_start
from tam570.integrate.dop853_source import functions
from tam570.integrate.engine import Engine
from tam570.integrate.formulas import Formulas
from tam570.integrate.scale import magnitudes
from tam570.integrate.tableau import NODES
from tam570.integrate.when_to_compile import Loop, carried_through

__all__ = ["TROUBLE", "at_start", "module", "scaled", "shortest_step", "states"]

TROUBLE = {
    NOT_FINITE: "rhs or solution is not finite at t = {t:.17g}",
    TOO_SHORT: "no step is short enough at t = {t:.17g}: the solution seems to become infinite there",
}


@lru_cache(maxsize=64)
def module(formulas: Formulas) -> str:
    """The module that numba compiles for these formulas."""
    from tam570.integrate import numba_backend

    text = functions(formulas, forgiving=False)
    return numba_backend.module_source(loop_with, text, "rhs, raised, step, dense, at", "advance")


def states(
    engine: Engine,
    times: Array,
    start: Array,
    rtol: float,
    how: str,
    floor: Sequence[float] = (),
    project: Callable[[Array], Any] | None = None,
    longest: Callable[[Array], float] | None = None,
) -> Array:
    """(n, k) states at `times`.

    how     : "auto", "python" or "numba"
    floor   : (k,) sizes by which components are judged at least
    project : project(y) -> y after every step
    longest : longest(y) -> s, no step from y is longer; only together with project
    """
    rows = np.empty((len(times), len(start)))
    rows[0] = start
    origin, since = float(times[0]), times - times[0]
    listed = since.tolist()

    def run(advance: Any, state: State, budget: int, by_numba: bool) -> State:
        tried = state.steps + state.refusals
        while True:
            left = budget + tried - state.steps - state.refusals
            state = advance(origin, since if by_numba else listed, rows, state, engine.constants, rtol, left)
            if state.halt != LACKS_SCALE:
                return State(*state)
            state = scaled(engine, origin, state)

    def share(state: State) -> float:
        return 1.0 if state.row == len(rows) or state.halt > LACKS_SCALE else state.t / listed[-1]

    source = partial(module, engine.formulas) if engine.traced and not project else None
    by_steps = _stepwise(engine, run, share, origin, project, longest) if project else run
    loop = Loop(by_steps, share, engine.functions["advance"], "advance", source)
    last = carried_through(loop, at_start(engine, origin, listed[-1], start, floor), how)
    if last.halt:
        raise ArithmeticError(TROUBLE[last.halt].format(t=origin + last.t))
    if project:
        rows[1:] = [project(row) for row in rows[1:]]
    return rows


def _stepwise(
    engine: Engine, run: Any, share: Any, origin: float, project: Callable[[Array], Any], longest: Any
) -> Callable[..., Any]:
    """`run` to the end with every step limited before and projected after."""

    def projected(advance: Any, state: Any, _budget: int, by_numba: bool) -> Any:
        while share(state) < 1:
            state = run(advance, _shortened(state, longest), 1, by_numba)
            state = _projected(engine, state, origin, project)
        return state

    return projected


def _shortened(state: State, longest: Callable[[Array], float] | None) -> State:
    return state if longest is None else state._replace(h=min(state.h, longest(np.array(state.y))))


def _projected(engine: Engine, state: State, origin: float, project: Callable[[Array], Any]) -> State:
    """The state brought back to where it belongs, with the derivative there."""
    y = tuple(np.asarray(project(np.array(state.y)), dtype=float).tolist())
    f = engine.functions["rhs"](origin + state.t, y, engine.constants)
    return state._replace(y=y, r=(0.0,) * len(y), f=f)


def at_start(engine: Engine, origin: float, span: float, start: Array, floor: Sequence[float] = ()) -> State:
    """The state that `advance` begins with; floor : (k,) sizes by which components are judged at least."""
    y, c, rhs = tuple(start.tolist()), engine.constants, engine.functions["rhs"]
    f = rhs(origin, y, c)
    if not all(map(math.isfinite, f)):
        check_start(engine.rates, origin, start)
    first_step = engine.functions["first_step"]
    h, g = first_step(origin, span, y, f, c), f
    if h < 1e-8 * span:  # the rates may jump at the very start
        g = rhs(origin + h, y, c)
        h = max(h, first_step(origin + h, span, y, g, c))
    later = _doubling(origin, h, span) if engine.formulas.timed else ()
    m = magnitudes(rhs, origin, h, y, g, floor or [0.0] * len(y), c, later)
    return State(1, 0.0, h, y, (0.0,) * len(y), f, m, LARGEST, 0, 0, 0, RUNNING)


def _doubling(origin: float, h: float, span: float) -> list[float]:
    """Times ever later: a force may not be there yet."""
    return [origin + h * 4.0**k for k in range(int(math.log(span / h, 4)) + 1)]


def scaled(engine: Engine, origin: float, state: State) -> State:
    """The state with a scale for what a step found moving that had none, if the times of its stages show one."""
    t, h, (y, f, m) = origin + state.t, state.h, (state.y, state.f, state.m)
    later = [t + 10 * h * node for node in NODES[1:13]]  # the step was ten times as long
    found = magnitudes(engine.functions["rhs"], t, 10 * h, y, f, m, engine.constants, later)
    return state._replace(m=found, halt=RUNNING)


def shortest_step(
    engine: Engine, times: Array, start: Array, rtol: float, floor: Sequence[float], steps: int = 200
) -> float:
    """The shortest of the steps that this method takes at `rtol` once it has found its pace; s."""
    origin, span = float(times[0]), float(times[-1] - times[0])
    rows, state, shortest = np.empty((2, len(start))), at_start(engine, origin, span, start, floor), span
    for step in range(200):
        before = state.t
        state = engine.functions["advance"](origin, [0.0, span], rows, state, engine.constants, rtol, 1)
        if state.row == 2 or state.halt:
            break
        if step > 5 and state.t > before:  # taken, not refused
            shortest = min(shortest, state.t - before)
    return shortest
