"""Runs of order 8 with automatic steps."""

from collections.abc import Callable
from functools import lru_cache, partial
from typing import Any

import numpy as np

from tam570.integrate.adaptive_loop import LARGEST, State, loop_with
from tam570.integrate.arguments import Array
from tam570.integrate.dop853_source import functions
from tam570.integrate.engine import Engine
from tam570.integrate.formulas import Formulas
from tam570.integrate.when_to_compile import Loop, carried_through

__all__ = ["at_start", "module", "shortest_step", "states"]


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
    project: Callable[[Array], Any] | None = None,
    longest: Callable[[Array], float] | None = None,
) -> Array:
    """(n, k) states at `times`.

    how     : "auto", "python" or "numba"
    project : project(y) -> y after every step
    longest : longest(y) -> s, no step from y is longer; only together with project
    """
    rows = np.empty((len(times), len(start)))
    rows[0] = start
    origin, since = float(times[0]), times - times[0]
    listed = since.tolist()

    def run(advance: Any, state: Any, budget: int, by_numba: bool) -> Any:
        return advance(origin, since if by_numba else listed, rows, state, engine.constants, rtol, budget)

    def share(state: Any) -> float:
        return 1.0 if state.row == len(rows) or state.h == 0.0 else state.t / listed[-1]

    source = partial(module, engine.formulas) if engine.traced and not project else None
    by_steps = _stepwise(engine, run, share, origin, project, longest) if project else run
    loop = Loop(by_steps, share, engine.functions["advance"], "advance", source)
    last = carried_through(loop, at_start(engine, origin, listed[-1], start), how)
    if last.h == 0.0:
        raise ArithmeticError(f"no step is short enough at t = {origin + last.t:.17g}: rhs or solution not finite")
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


def at_start(engine: Engine, origin: float, span: float, start: Array) -> State:
    """The state that `advance` begins with; what starts at zero has the magnitude that it will have before long."""
    y, c = tuple(start.tolist()), engine.constants
    f = engine.functions["rhs"](origin, y, c)
    h = engine.functions["first_step"](origin, span, y, f, c)
    soon = engine.functions["rhs"](origin + h / 100, engine.functions["euler"](h / 100, y, f), c)
    m = tuple(map(_magnitude, y, f, soon, [h] * len(y)))
    return State(1, 0.0, h, y, (0.0,) * len(y), f, m, LARGEST, 0, 0, 0)


def _magnitude(y: float, rate: float, soon: float, h: float) -> float:
    """The size of a component, or where it starts at zero what it will be before long; never 0, as it divides."""
    moved = h * abs(rate) or h / 100 * abs(soon)
    return max(abs(y), moved if moved < float("inf") else 0.0, 1e-300)


def shortest_step(engine: Engine, times: Array, start: Array, rtol: float, *, steps: int = 200) -> float:
    """The shortest of the steps that this method takes at `rtol` once it has found its pace; s."""
    origin, span = float(times[0]), float(times[-1] - times[0])
    rows, state, shortest = np.empty((2, len(start))), at_start(engine, origin, span, start), span
    for step in range(steps):
        before = state.t
        state = engine.functions["advance"](origin, [0.0, span], rows, state, engine.constants, rtol, 1)
        if state.row == 2 or state.h == 0.0:
            break
        if step > 5 and state.t > before:  # taken, not refused
            shortest = min(shortest, state.t - before)
    return shortest
