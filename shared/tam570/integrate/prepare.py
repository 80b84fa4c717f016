"""Runs of one right-hand side, one after the other: what does not depend on the start is done once."""

from collections.abc import Callable
from functools import partial

import numpy as np
from numpy.typing import ArrayLike

from tam570.integrate.arguments import Array, checked
from tam570.integrate.compiled_cache import compile_run
from tam570.integrate.engine import engine
from tam570.integrate.solver import solve
from tam570.values import Function, Parameters

__all__ = ["prepared"]


def prepared(
    rhs: Function,
    t: ArrayLike,
    y0: ArrayLike,
    *,
    parameters: Parameters | None = None,
    rtol: float = 1e-10,
    atol: ArrayLike | None = None,
) -> Callable[[ArrayLike], Array]:
    """Prepare a function of the start alone, for many short runs in a row.

    `prepared` validates, traces and compiles once what does not depend on the start. It does not notice later
    changes of what the right-hand side depends on.

    Parameters
    ----------
    y0 : (k,) array_like
        One of the starts; the trace is tested with it.
    rhs, t, parameters, rtol, atol
        As in `solve`.

    Returns
    -------
    callable
        run(y0) returns what `solve` returns from there.

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
        prepared_engine = engine(rhs, parameters, times, start.reshape(-1, start.shape[-1])[0], sign=sign)
    compiled_run = compile_run(prepared_engine, times, control)

    def run(y0: ArrayLike) -> Array:
        rows = compiled_run(y0)
        if rows is None:
            if np.shape(y0)[-1:] != start.shape[-1:]:
                raise ValueError(f"y0: need {start.shape[-1]} numbers, as when it was prepared, got {y0!r}")
            rows = in_full(y0)
        return rows

    return run
