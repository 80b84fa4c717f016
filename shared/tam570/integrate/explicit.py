"""Runge-Kutta of order 8 with automatic steps."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import lru_cache, partial
from types import FunctionType
from typing import Any

import numpy as np

from tam570.integrate import drive
from tam570.integrate.pace import Loop, carried_through
from tam570.integrate.problem import Array, agrees, bound, check_start, floats_function
from tam570.integrate.source import Formulas, call_of, compiled, functions
from tam570.integrate.trace import traced

__all__ = ["Engine", "at_start", "engine", "module", "shortest_step", "states"]


@dataclass(frozen=True)
class Engine:
    """The functions generated for a right-hand side, and the constants of its scene."""

    functions: dict[str, Any]
    constants: tuple[float, ...]
    formulas: Formulas
    traced: bool


def engine(rhs: Callable[..., Any], parameters: Mapping[str, Any] | None, times: Array, start: Array) -> Engine:
    """Functions for the right-hand side as traced, if it can be and agrees; else for calls of it."""
    rates, sampled = bound(rhs, parameters), len(times) > 2
    check_start(rates, float(times[0]), start)
    try:
        found = _traced(rhs, tuple((parameters or {}).items()), len(start), sampled)
        if agrees(rates, found.functions["rhs"], found.constants, times, start):
            return found
    except Exception:  # whatever a function says to symbols, it then gets numbers
        pass
    given = floats_function(rates, float(times[0]), start)
    formulas = call_of(len(start))
    return Engine(_with_loop(compiled(formulas, sampled, given)), (), formulas, False)


def _traced(rhs: Callable[..., Any], items: tuple[tuple[str, Any], ...], size: int, sampled: bool) -> Engine:
    """The engine of a traced right-hand side, kept for the next run with these very parameters.

    Kept ones are compared with the function again, as all are: what it refers to may have changed.
    """
    try:
        formulas, constants = _formulas(rhs, items, size)
    except TypeError:  # parameters that cannot be told apart by a hash, arrays for one
        formulas, constants = traced(bound(rhs, dict(items)), size)
    return Engine(_functions(formulas, sampled), constants, formulas, True)


@lru_cache(maxsize=256)
def _formulas(rhs: Any, items: tuple[tuple[str, Any], ...], size: int) -> tuple[Formulas, tuple[float, ...]]:
    return traced(bound(rhs, dict(items)), size)


@lru_cache(maxsize=256)
def _functions(formulas: Formulas, sampled: bool) -> dict[str, Any]:
    return _with_loop(compiled(formulas, sampled))


def _with_loop(namespace: dict[str, Any]) -> dict[str, Any]:
    """The generated functions and, with these for its global names, the loop around them."""
    merged = {**vars(drive), **namespace}
    for loop in (drive.restless, drive.first_step, drive.advance):
        merged[loop.__name__] = FunctionType(loop.__code__, merged)
    return merged


@lru_cache(maxsize=64)
def module(formulas: Formulas) -> str:
    """The module that numba compiles for these formulas."""
    from tam570.integrate import machine

    text = functions(formulas, forgiving=False)
    return machine.module_source(drive, text, "rhs, raised, step, dense, at", "advance")


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
        row, reached, h, *_ = state
        return 1.0 if row == len(rows) or h == 0.0 else reached / listed[-1]

    source = partial(module, engine.formulas) if engine.traced and not project else None
    by_steps = _stepwise(engine, run, share, origin, project, longest) if project else run
    loop = Loop(by_steps, share, engine.functions["advance"], "advance", source)
    _, reached, h, *_ = carried_through(loop, at_start(engine, origin, listed[-1], start), how)
    if h == 0.0:
        raise ArithmeticError(f"no step is short enough at t = {origin + reached:.17g}: rhs or solution not finite")
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


def _shortened(state: Any, longest: Callable[[Array], float] | None) -> Any:
    if longest is None:
        return state
    row, t, h, y, *rest = state
    return row, t, min(h, longest(np.array(y))), y, *rest


def _projected(engine: Engine, state: Any, origin: float, project: Callable[[Array], Any]) -> Any:
    """The state brought back to where it belongs, with the derivative there."""
    row, t, h, y, _, _, m = state
    y = tuple(np.asarray(project(np.array(y)), dtype=float).tolist())
    return row, t, h, y, (0.0,) * len(y), engine.functions["rhs"](origin + t, y, engine.constants), m


def at_start(engine: Engine, origin: float, span: float, start: Array) -> tuple[Any, ...]:
    """The state that `advance` begins with; what starts at zero has the magnitude that it will have before long."""
    y, c = tuple(start.tolist()), engine.constants
    f = engine.functions["rhs"](origin, y, c)
    h = engine.functions["first_step"](origin, span, y, f, c)
    soon = engine.functions["rhs"](origin + h / 100, engine.functions["euler"](h / 100, y, f), c)
    m = tuple(map(_magnitude, y, f, soon, [h] * len(y)))
    return 1, 0.0, h, y, (0.0,) * len(y), f, m


def _magnitude(y: float, rate: float, soon: float, h: float) -> float:
    """The size of a component, or where it starts at zero what it will be before long; never 0, as it divides."""
    moved = h * abs(rate) or h / 100 * abs(soon)
    return max(abs(y), moved if moved < float("inf") else 0.0, 1e-300)


def shortest_step(engine: Engine, times: Array, start: Array, rtol: float, *, steps: int = 200) -> float:
    """The shortest of the steps that this method takes at `rtol` once it has found its pace; s."""
    origin, span = float(times[0]), float(times[-1] - times[0])
    rows, state, shortest = np.empty((2, len(start))), at_start(engine, origin, span, start), span
    for step in range(steps):
        before = state[1]
        state = engine.functions["advance"](origin, [0.0, span], rows, state, engine.constants, rtol, 1)
        if state[0] == 2 or state[2] == 0.0:
            break
        if step > 5 and state[1] > before:  # taken, not refused
            shortest = min(shortest, state[1] - before)
    return shortest
