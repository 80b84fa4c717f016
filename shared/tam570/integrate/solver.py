"""The one function everybody calls: `solve`."""

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from tam570.integrate import explicit, longterm
from tam570.integrate.problem import Array, bound, initial_state, sample_times, tolerance

__all__ = ["solve"]

METHODS = ("auto", "python", "numba", *longterm.METHODS)


def solve(
    rhs: Callable[..., Any],
    t: ArrayLike,
    y0: ArrayLike,
    *,
    parameters: Mapping[str, Any] | None = None,
    rtol: float = 1e-10,
    method: str = "auto",
    step: float | None = None,
    project: Callable[[Array], Any] | None = None,
) -> Array:
    """States at the times `t` of y' = rhs(t, y, **parameters), y(t[0]) = y0.

    rhs        : rhs(t, y, **parameters) -> k numbers; NumPy or plain floats inside
    t          : (n,) strictly increasing, n >= 2; the choice of times does not change the steps taken
    y0         : (k,), or (m, k) for m starts at once
    parameters : keyword arguments of rhs, bound before the first step
    rtol       : largest error of a step, relative to the largest magnitude so far of each component
    method     : "auto" runs in Python and goes on compiled by numba where that is installed and repays;
                 "python" and "numba" insist; at a fixed step, for long runs of conservative systems:
                 "gauss" (Gauss-Legendre, order 12), "composition" (order 8, y0 = (q, v), q' of v, v' of q)
    step       : s, of the methods with a fixed one; left out it follows from rtol
    project    : project(y) -> the nearest allowed state, applied after every step: for holonomic constraints
    Returns (n, k), row 0 is y0; or (m, n, k).
    ValueError names the argument that does not fit; ArithmeticError tells where the solution or rhs ceases
    to be finite.
    """
    times, start, rtol = sample_times(t), initial_state(y0), tolerance(rtol)
    if method not in METHODS:
        raise ValueError(f"method: one of {', '.join(METHODS)}, got {method!r}")
    with np.errstate(all="ignore"):  # a step that proves too long may overflow: it is taken again
        if start.ndim == 2:
            return _ensemble(rhs, parameters, times, start, rtol, method)
        kit = explicit.engine(rhs, parameters, times, start)
        if method in longterm.METHODS:
            if project is not None:
                raise ValueError(f'project: goes with method "auto" or "python", not with {method!r}')
            return longterm.states(method, kit, bound(rhs, parameters), times, start, rtol, step)
        return explicit.states(kit, times, start, rtol, method, project)


def _ensemble(
    rhs: Callable[..., Any], parameters: Any, times: Array, starts: Array, rtol: float, method: str
) -> Array:
    from tam570.integrate import ensemble

    if method in longterm.METHODS:
        raise ValueError(f'y0: several starts at once go with method "auto", not with {method!r}')
    kit = explicit.engine(rhs, parameters, times, starts[0])
    return ensemble.states(kit, times, starts, rtol, method)
