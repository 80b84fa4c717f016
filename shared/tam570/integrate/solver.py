"""The one function everybody calls: `solve`."""

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from tam570.integrate import adaptive
from tam570.integrate.arguments import Array, allowed_error, initial_state, of_one_step, sample_times, tolerance
from tam570.integrate.engine import engine

__all__ = ["solve"]

FIXED_STEP = ("gauss", "composition")
METHODS = ("auto", "python", "compiled", *FIXED_STEP)


def solve(
    rhs: Callable[..., Any],
    t: ArrayLike,
    y0: ArrayLike,
    *,
    parameters: Mapping[str, Any] | None = None,
    rtol: float = 1e-10,
    atol: ArrayLike | None = None,
    method: str = "auto",
    step: float | None = None,
    project: Callable[[Array], Any] | None = None,
) -> Array:
    """States at the times `t` of y' = rhs(t, y, **parameters), y(t[0]) = y0.

    rhs        : rhs(t, y, **parameters) -> k numbers; NumPy or plain floats inside
    t          : (n,) strictly increasing, n >= 2; the choice of times does not change the steps taken
    y0         : (k,), or (m, k) for m starts at once
    parameters : keyword arguments of rhs, bound before the first step
    rtol       : largest error of a step, relative to the largest magnitude so far of each component; what starts at
                 zero takes the size to which it, time, or the other components move it within the first step
    atol       : an error of a step that is allowed in any case, one number or k; left out, none but that of rtol
    method     : "auto" runs in Python and goes on compiled by llvmlite where that is installed and repays;
                 "python" and "compiled" insist; at a fixed step, for long runs of conservative systems:
                 "gauss" (Gauss-Legendre, order 12), "composition" (order 8, y0 = (q, v), q' of v, v' of q)
                 these two also reach the last digits of a hundred periods, where the others' energy drifts
    step       : s, of "gauss" and "composition" alone, no longer than this; left out it follows from rtol
    project    : project(y) -> the nearest allowed state, applied after every step: for holonomic constraints
    Returns (n, k), row 0 is y0; or (m, n, k).
    ValueError names the argument, ArithmeticError the time at which rhs or solution cease to be finite.
    """
    times, start, asked = sample_times(t), initial_state(y0), tolerance(rtol)
    rtol = of_one_step(asked)
    floor = [allowed / rtol for allowed in allowed_error(atol, start.shape[-1])]
    _check_method(method, several=start.ndim == 2, projected=project is not None, stepped=step is not None)
    with np.errstate(all="ignore"):  # a step that proves too long may overflow: it is taken again
        if start.ndim == 2:
            from tam570.integrate import ensemble

            return ensemble.states(engine(rhs, parameters, times, start[0]), times, start, rtol, method, floor)
        made = engine(rhs, parameters, times, start)
        if method in FIXED_STEP:
            from tam570.integrate import fixed_step

            return fixed_step.states(method, made, times, start, asked, floor, step)
        return adaptive.states(made, times, start, rtol, method, floor, project)


def _check_method(method: str, *, several: bool, projected: bool, stepped: bool) -> None:
    if method not in METHODS:
        raise ValueError(f"method: one of {', '.join(METHODS)}, got {method!r}")
    if method in FIXED_STEP and several:
        raise ValueError(f'y0: several starts at once go with method "auto", not with {method!r}')
    if projected and (method in FIXED_STEP or several):
        raise ValueError('project: goes with one start and method "auto" or "python" alone')
    if stepped and method not in FIXED_STEP:
        raise ValueError(f'step: goes with method "gauss" or "composition" alone, {method!r} takes rtol')
