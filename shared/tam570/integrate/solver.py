"""The main functions of the package: `solve`, and `prepared` for repeated runs.

rtol, atol
    If you omit atol, it is a quarter of rtol times the scale of each component: its size at the start, or, if it starts
    at zero, the size to which its rate, time or other components first move it. If a pulse then moves it so far beyond
    this scale that round-off allows no step, the scale grows to the size of this motion. `report` returns atol. Errors
    that round-off causes in any case are tolerated, so rtol = 1e-14 gives all digits that round-off permits, and
    any smaller rtol acts like it. If a component falls far below its atol and then grows again, as in y' = (t - 10) y,
    its error grows by the same factor: give atol=0.
method
    "auto" starts like "python", counts its steps, and starts again like "compiled" (with llvmlite, if installed) if so
    many steps remain that compilation is worthwhile. With events or dense it is always "python". The same call gives
    the same bits, independent of earlier calls. Two methods have a fixed step size, for long runs of conservative
    systems: "gauss" (Gauss-Legendre, order 12) and "composition" (order 8, y0 = (q, v), q' depends on v, v' on q). They
    get a hundred periods right to the last digits, where the energy of the other methods drifts.
events
    event.direction > 0 selects zero crossings from below, < 0 from above. event.terminal = True ends the run at the
    first crossing, n at the n-th. A zero at the start is no crossing, nor is a touch; two zeros within a thousandth of
    a step may count as a touch. A `Motion` has t and states up to a terminal event, events, at, report.
errors
    ValueError names the argument. ArithmeticError gives the time at which rhs or solution is no longer finite, or at
    which the equations are stiff, and suggests a remedy.

>>> def falling(t, y, *, gravity):
...     return y[1], -gravity
>>> def ground(t, y, *, gravity):
...     return y[0]
>>> ground.terminal = True
>>> motion = solve(falling, [0, 10], [5.0, 0.0], parameters={"gravity": 10.0}, events=ground, dense=True)
>>> motion.events[0].t.round(12).tolist(), motion.at(0.5).round(9).tolist()
([1.0], [3.75, -5.0])
"""

import math
from collections.abc import Callable, Sequence
from functools import partial
from typing import TYPE_CHECKING, Literal, overload

import numpy as np
from numpy.typing import ArrayLike

from tam570.integrate import adaptive, compiled_cache
from tam570.integrate.arguments import Array, checked, positive
from tam570.integrate.compiled_cache import compile_run
from tam570.integrate.engine import Mistraced, engine
from tam570.integrate.rates import RhsError
from tam570.integrate.watch import COMPILED
from tam570.values import Function, Numbers, Parameters

if TYPE_CHECKING:
    from tam570.integrate.events import Motion

FIXED_STEP = ("gauss", "composition")
METHODS = ("auto", "python", "compiled", *FIXED_STEP)

Events = Callable[..., float] | Sequence[Callable[..., float]]


@overload
def solve(
    rhs: Function,
    t: ArrayLike,
    y0: ArrayLike,
    *,
    parameters: Parameters | None = ...,
    rtol: float = ...,
    atol: ArrayLike | None = ...,
    method: str = ...,
    step: float | None = ...,
    max_step: float = ...,
    first_step: float | None = ...,
    project: Callable[[Array], Numbers] | None = ...,
    events: None = ...,
    dense: Literal[False] = ...,
    report: Literal[False] = ...,
) -> Array: ...
@overload
def solve(
    rhs: Function,
    t: ArrayLike,
    y0: ArrayLike,
    *,
    parameters: Parameters | None = ...,
    rtol: float = ...,
    atol: ArrayLike | None = ...,
    method: str = ...,
    max_step: float = ...,
    first_step: float | None = ...,
    events: Events | None = ...,
    dense: bool = ...,
    report: bool = ...,
) -> "Motion": ...
def solve(
    rhs: Function,
    t: ArrayLike,
    y0: ArrayLike,
    *,
    parameters: Parameters | None = None,
    rtol: float = 1e-10,
    atol: ArrayLike | None = None,
    method: str = "auto",
    step: float | None = None,
    max_step: float = math.inf,
    first_step: float | None = None,
    project: Callable[[Array], Numbers] | None = None,
    events: Events | None = None,
    dense: bool = False,
    report: bool = False,
) -> "Array | Motion":
    """Solve `y' = rhs(t, y, **parameters)`, `y(t[0]) = y0`, and return the states at the times `t`.

    Parameters
    ----------
    rhs : callable
        `rhs(t, y, **parameters)` returns k numbers, with NumPy or plain floats inside. Parameters are bound at
        the start.
    t : (n,) array_like
        Strictly increasing or decreasing, n >= 2. Times between t[0] and t[-1] do not affect the steps.
    y0 : (k,) or (m, k) array_like
        One start, or m starts at once if k > 1: a column may be one start that was not flattened.
    parameters : mapping, optional
        Keyword arguments of rhs.
    rtol, atol : float, atol also (k,)
        The local error of a step may be atol + rtol * abs(y). If you omit atol, it follows from the start. Give
        atol=0 if a component falls far below its size at the start and then grows again.
    method : str
        "auto", "python" or "compiled"; or, with a fixed step for long conservative runs, "gauss" or "composition".
    step : float, optional
        Largest step size of "gauss" and "composition", in s. If you omit it, it follows from rtol.
    max_step, first_step : float, optional
        Largest and first step size of the other methods, in s, as in SciPy's solve_ivp.
    project : callable, optional
        project(y) returns the nearest allowed state; `solve` applies it after every step, for holonomic constraints.
    events : callable or list of callables, optional
        `event(t, y, **parameters)` returns a number; `solve` finds where it crosses zero, after t[0] (SciPy's
        solve_ivp also returns a zero at t[0]).
    dense, report : bool
        Also return the motion as a function of time; also return statistics of the run.

    Returns
    -------
    (n, k) or (m, n, k) ndarray, or Motion
        Row 0 is y0. With events, dense or report, a `Motion`.

    Raises
    ------
    ValueError
        If an argument does not fit; the message names it.
    ArithmeticError
        If rhs or solution is no longer finite, or the equations become stiff; the message gives the time.

    Examples
    --------
    >>> solve(lambda t, y: (y[1], -y[0]), [0.0, math.pi], [1.0, 0.0])[-1].round(9)
    array([-1., -0.])
    """
    more = events is not None or dense or report
    plain = not more and step is None and project is None and first_step is None and max_step == math.inf
    slot = compiled_cache.slot_of(method, rhs, t, y0, parameters, rtol, atol) if plain else None
    if slot and (rows := slot[-1](y0)) is not None:
        return rows
    times, sign, start, control = checked(t, y0, rtol, atol)
    _check_method(method, several=start.ndim == 2, projected=project is not None, stepped=step is not None, more=more)
    if max_step != math.inf or first_step is not None:
        if method in FIXED_STEP:
            raise ValueError(f"max_step, first_step: {method!r} takes step")
        first = None if first_step is None else positive("first_step", first_step)
        if times[-1] - times[0] > COMPILED * positive("max_step", max_step):
            raise ValueError(f"max_step: {max_step!r} is too short for a run of {times[-1] - times[0]:g} s")
        control = control._replace(max_step=float(max_step), first_step=first)
    control = control._replace(project=project)

    def run(may_trace: bool) -> "Array | Motion":
        first, sampled = np.atleast_2d(start)[0], events is not None or dense
        run_engine = engine(rhs, parameters, times, first, sign=sign, sampled=sampled, may_trace=may_trace)
        if more:
            from tam570.integrate.events import motion

            return motion(run_engine, times, start, control, events, parameters, dense, method)
        if method in FIXED_STEP:
            from tam570.integrate import fixed_step

            return fixed_step.states(method, run_engine, times, start, control, step)
        if start.ndim == 2:
            return adaptive.ensemble(run_engine, times, start, method, control)
        solution = adaptive.integrate(run_engine, times, start, method, control)
        if slot is not None and solution.engine == "compiled":
            compiled_cache.keep(slot, run_engine, times, control)
        return solution.rows

    with np.errstate(all="ignore"):  # a step that is too long may overflow; it is repeated
        try:
            return run(may_trace=True)
        except Mistraced:
            return run(may_trace=False)
        except RhsError as error:
            raise ValueError(str(error)) from None


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


def prepared(
    rhs: Function,
    t: ArrayLike,
    y0: ArrayLike,
    *,
    parameters: Parameters | None = None,
    rtol: float = 1e-10,
    atol: ArrayLike | None = None,
) -> Callable[[ArrayLike], Array]:
    """Prepare a function of the start, for many short runs with the same right-hand side, times and tolerances.

    `prepared` validates, traces and compiles once. It does not notice later changes of objects that the right-hand side
    depends on.

    Parameters
    ----------
    y0 : (k,) array_like
        One of the starts; the trace is tested with it.
    rhs, t, parameters, rtol, atol
        As in `solve`.

    Returns
    -------
    callable
        run(y0) returns the states of `solve` within the tolerance; it may use compiled code where `solve` uses Python.

    Examples
    --------
    >>> def falling(t, y, *, gravity):
    ...     return y[1], -gravity
    >>> run = prepared(falling, [0.0, 1.0], [0.0, 0.0], parameters={"gravity": 10.0})
    >>> run([5.0, 0.0])[-1].tolist(), run([0.0, 5.0])[-1].tolist()
    ([0.0, -10.0], [0.0, -5.0])
    """
    times, sign, start, control = checked(t, y0, rtol, atol)
    parameters = dict(parameters or {})
    in_full = partial(solve, rhs, sign * times, parameters=parameters, rtol=rtol, atol=atol)
    with np.errstate(all="ignore"):
        try:
            prepared_engine = engine(rhs, parameters, times, start.reshape(-1, start.shape[-1])[0], sign=sign)
        except RhsError as error:
            raise ValueError(str(error)) from None
    adaptive.check_clock(prepared_engine, times, start.reshape(-1, start.shape[-1])[0], control.rtol)
    compiled_run = compile_run(prepared_engine, times, control)

    def run(y0: ArrayLike) -> Array:
        rows = compiled_run(y0)
        if rows is None:
            if np.shape(y0)[-1:] != start.shape[-1:]:
                raise ValueError(f"y0: need {start.shape[-1]} numbers, as when it was prepared, got {y0!r}")
            rows = in_full(y0)
        return rows

    return run
