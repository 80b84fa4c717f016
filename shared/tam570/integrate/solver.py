"""The one function everybody calls: `solve`.

rtol
    What starts at zero takes the size to which it, time, or the other components first move it. An error that the
    rounding of these makes in any case is allowed; 1e-14 gets all the digits that rounding leaves.
method
    "auto" runs in Python and goes on compiled by llvmlite where that is installed and repays; "python" and "compiled"
    insist. Two run at a fixed step, for long runs of conservative systems: "gauss" (Gauss-Legendre, order 12) and
    "composition" (order 8, y0 = (q, v), q' of v, v' of q). They also reach the last digits of a hundred periods, where
    the others' energy drifts.
events
    event.direction > 0 asks for zeros from below, < 0 from above. event.terminal = True ends the run at the first,
    n at the n-th. A zero at the start is none. A `Motion` has t and states up to a terminal event, events, at, report.
errors
    ValueError names the argument, ArithmeticError the time at which rhs or solution cease to be finite, or from which
    on the equations are stiff, with the remedy.

>>> def falling(t, y, *, gravity):
...     return y[1], -gravity
>>> def ground(t, y, *, gravity):
...     return y[0]
>>> ground.terminal = True
>>> motion = solve(falling, [0, 10], [5.0, 0.0], parameters={"gravity": 10.0}, events=ground, dense=True)
>>> motion.events[0].t.round(12).tolist(), motion.at(0.5).round(9).tolist()
([1.0], [3.75, -5.0])
"""

from collections.abc import Callable, Mapping, Sequence
from typing import Any, Literal, overload

import numpy as np
from numpy.typing import ArrayLike

from tam570.integrate import adaptive, again
from tam570.integrate.arguments import Array, checked, of_one_step
from tam570.integrate.engine import Engine, engine
from tam570.integrate.motion import Motion

__all__ = ["solve"]

FIXED_STEP = ("gauss", "composition")
METHODS = ("auto", "python", "compiled", *FIXED_STEP)

Events = Callable[..., float] | Sequence[Callable[..., float]]


@overload
def solve(
    rhs: Callable[..., Any],
    t: ArrayLike,
    y0: ArrayLike,
    *,
    parameters: Mapping[str, Any] | None = ...,
    rtol: float = ...,
    atol: ArrayLike | None = ...,
    method: str = ...,
    step: float | None = ...,
    project: Callable[[Array], Any] | None = ...,
    events: None = ...,
    dense: Literal[False] = ...,
    report: Literal[False] = ...,
) -> Array: ...
@overload
def solve(
    rhs: Callable[..., Any],
    t: ArrayLike,
    y0: ArrayLike,
    *,
    parameters: Mapping[str, Any] | None = ...,
    rtol: float = ...,
    atol: ArrayLike | None = ...,
    method: str = ...,
    events: Events | None = ...,
    dense: bool = ...,
    report: bool = ...,
) -> Motion: ...
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
    events: Events | None = None,
    dense: bool = False,
    report: bool = False,
) -> Array | Motion:
    """States at the times `t` of y' = rhs(t, y, **parameters), y(t[0]) = y0; the module's docstring says more.

    rhs        : rhs(t, y, **parameters) -> k numbers; NumPy or plain floats inside; parameters are bound at the start
    t          : (n,) strictly increasing or decreasing, n >= 2; the choice of times does not change the steps taken
    y0         : (k,), or (m, k) for m starts at once
    rtol, atol : largest error of a step, relative to the largest magnitude so far; error allowed in any case, 1 or k
    method     : "auto", "python", "compiled"; at a fixed step, for long conservative runs, "gauss", "composition"
    step       : s, of the last two alone: no longer than this; left out it follows from rtol
    project    : project(y) -> the nearest allowed state, applied after every step: for holonomic constraints
    events     : event(t, y, **parameters) -> a number whose zeros are found, as in solve_ivp; or a list of such
    dense, report : also give the motion as a function of time; also tell how the run went
    Returns (n, k), row 0 is y0; or (m, n, k). With events, dense or report a `Motion`.
    ValueError names the argument; ArithmeticError says when rhs or solution cease to be finite, or become stiff.
    """
    plain = not (more := events is not None or dense or report) and step is None and project is None
    place = again.place_of(method, rhs, t, y0, parameters, rtol, atol) if plain else None
    if place and (rows := place[-1](y0)) is not None:
        return rows
    times, sign, start, asked, floor = checked(t, y0, rtol, atol)
    _check_method(method, several=start.ndim == 2, projected=project is not None, stepped=step is not None, more=more)
    with np.errstate(all="ignore"):  # a step that proves too long may overflow: it is taken again
        made = engine(rhs, parameters, times, np.atleast_2d(start)[0], sign=sign, sampled=events is not None or dense)
        if more:
            return _motion(made, times, start, of_one_step(asked), floor, events, parameters, dense, method)
        return _states(made, times, start, asked, floor, method, step, project, place)


def _motion(*known: Any) -> Motion:
    from tam570.integrate.watched import motion

    return motion(*known)


def _states(
    made: Engine,
    times: Array,
    start: Array,
    asked: float,
    floor: list[float],
    method: str,
    step: float | None,
    project: Callable[[Array], Any] | None,
    place: again.Place | None,
) -> Array:
    if method in FIXED_STEP:
        from tam570.integrate import fixed_step

        return fixed_step.states(method, made, times, start, asked, floor, step)
    if start.ndim == 2:
        from tam570.integrate import ensemble

        return ensemble.states(made, times, start, of_one_step(asked), method, floor)
    rows = adaptive.states(made, times, start, of_one_step(asked), method, floor, project)
    if place is not None:
        again.keep(place, made, times, of_one_step(asked), floor)
    return rows


def _check_method(method: str, *, several: bool, projected: bool, stepped: bool, more: bool) -> None:
    if method not in METHODS:
        raise ValueError(f"method: one of {', '.join(METHODS)}, got {method!r}")
    if method in FIXED_STEP and several:
        raise ValueError(f'y0: several starts at once go with method "auto", not with {method!r}')
    if projected and (method in FIXED_STEP or several):
        raise ValueError('project: goes with one start and method "auto" or "python" alone')
    if stepped and method not in FIXED_STEP:
        raise ValueError(f'step: goes with method "gauss" or "composition" alone, {method!r} takes rtol')
    if more and (several or projected or method in FIXED_STEP):
        raise ValueError("events, dense, report: go with one start, no project, and a method that chooses its steps")
