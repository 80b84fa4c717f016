"""The one function everybody calls: `solve`."""

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from tam570.integrate.drive import advance, first_step
from tam570.integrate.problem import (
    Array,
    Rates,
    agrees,
    bound,
    floats_function,
    initial_state,
    sample_times,
    tolerance,
)
from tam570.integrate.source import call_of, compiled
from tam570.integrate.trace import traced

__all__ = ["solve"]


def solve(
    rhs: Callable[..., Any],
    t: ArrayLike,
    y0: ArrayLike,
    *,
    parameters: Mapping[str, Any] | None = None,
    rtol: float = 1e-10,
    method: str = "auto",
) -> Array:
    """States at the times `t` of y' = rhs(t, y, **parameters), y(t[0]) = y0.

    rhs : rhs(t, y, **parameters) -> k numbers
    t   : (n,) strictly increasing, n >= 2
    y0  : (k,)
    Returns (n, k); row 0 is y0.
    """
    times, start, rtol = sample_times(t), initial_state(y0), tolerance(rtol)
    rates = bound(rhs, parameters)
    with np.errstate(all="ignore"):  # a step that proves too long may overflow: it is taken again
        engine, constants = _engine(rates, times, start)
        return _run(engine, times, start, constants, rtol)


def _engine(rates: Rates, times: Array, start: Array) -> tuple[dict[str, Any], tuple[float, ...]]:
    """The generated functions: for the right-hand side as traced if it can be, and agrees; else for calls of it."""
    try:
        formulas, constants = traced(rates, len(start))
        engine = compiled(formulas, len(times) > 2)
        if agrees(rates, engine["rhs"], constants, times, start):
            return engine, constants
    except Exception:  # whatever a function says to symbols, it then gets numbers
        pass
    given = floats_function(rates, float(times[0]), start)
    return compiled(call_of(len(start)), len(times) > 2, given), ()


def _run(
    engine: dict[str, Any], times: Array, start: Array, constants: tuple[float, ...], rtol: float
) -> Array:
    states = np.empty((len(times), len(start)))
    states[0] = start
    origin, since = float(times[0]), (times - times[0]).tolist()
    y = tuple(start.tolist())
    f = engine["rhs"](origin, y, constants)
    h = first_step(engine["rhs"], engine["euler"], origin, since[-1], y, f, tuple(map(abs, y)), constants)
    m = tuple(
        max(abs(x), h * abs(rate), 1e-300) for x, rate in zip(y, f, strict=True)
    )  # never zero: it divides
    at_rest = (1, 0.0, h, y, (0.0,) * len(y), f, m)
    step, raised, dense, at = (engine[name] for name in ("step", "raised", "dense", "at"))
    row, reached, h, *_ = advance(
        step, raised, dense, at, origin, since, states, at_rest, constants, rtol, float("inf")
    )
    if h == 0.0:
        raise ArithmeticError(
            f"no step is small enough at t = {origin + reached:.17g}: the solution or rhs is not finite"
        )
    return states
