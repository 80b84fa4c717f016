"""Runs of one right-hand side, one after the other: what does not depend on the start is done once."""

from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from tam570.integrate.adaptive import Run
from tam570.integrate.arguments import Array, allowed_error, initial_state, of_one_step, sample_times, tolerance
from tam570.integrate.engine import Engine, engine
from tam570.integrate.solver import solve
from tam570.integrate.stiffness import COMPILED
from tam570.integrate.when_to_compile import available

__all__ = ["prepared"]

At_once = Callable[[Any], Array | None]


def prepared(
    rhs: Callable[..., Any],
    t: ArrayLike,
    y0: ArrayLike,
    *,
    parameters: Mapping[str, Any] | None = None,
    rtol: float = 1e-10,
    atol: ArrayLike | None = None,
) -> Callable[[ArrayLike], Array]:
    """run(y0) -> what `solve` gives from there, with the other arguments as they are now.

    For many short runs in turn: a call of `run` checks, looks up and allocates next to nothing. The right-hand side is
    traced and compiled here, where it can be; later changes of what it depends on are not seen.

    y0 : (k,) one of the starts, by which the trace is tried
    The other arguments, the results and the errors are those of `solve`.

    >>> def falling(t, y, *, gravity):
    ...     return y[1], -gravity
    >>> run = prepared(falling, [0.0, 1.0], [0.0, 0.0], parameters={"gravity": 10.0})
    >>> run([5.0, 0.0])[-1].tolist(), run([0.0, 5.0])[-1].tolist()
    ([0.0, -10.0], [0.0, -5.0])
    """
    (times, sign), start, held = sample_times(t), initial_state(y0), dict(parameters or {})
    in_full = partial(solve, rhs, sign * times, parameters=held, rtol=rtol, atol=atol)
    step_rtol = of_one_step(tolerance(rtol))
    floor = [allowed / step_rtol for allowed in allowed_error(atol, start.shape[-1])]
    with np.errstate(all="ignore"):
        made = engine(rhs, held, times, start.reshape(-1, start.shape[-1])[0], sign=sign)
    at_once = _compiled(made, times, step_rtol, floor)

    def run(y0: ArrayLike) -> Array:
        rows = at_once(y0)
        if rows is None:
            if np.shape(y0)[-1:] != start.shape[-1:]:
                raise ValueError(f"y0: need {start.shape[-1]} numbers, as when it was prepared, got {y0!r}")
            rows = in_full(y0)
        return rows

    return run


def _compiled(made: Engine, times: Array, rtol: float, floor: list[float]) -> At_once:
    """States at `times` by Taylor's method alone; None where it does not get there."""
    if made.graph is None or not available():
        return lambda y0: None
    whole = Run(made, float(times[0]), times - times[0], np.empty((len(times), made.formulas.size)), rtol)
    try:
        from tam570.integrate.compiled import repeated

        runs = repeated.taylor_repeated(made.graph, whole, floor, partial(whole.watch, COMPILED))
    except (ImportError, OSError, RuntimeError):  # a broken llvmlite: nobody asked for it
        runs = None
    return runs or (lambda y0: None)
