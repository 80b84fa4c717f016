"""The one function everybody calls: `solve`."""

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["solve"]

Array = NDArray[np.float64]


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
    from scipy.integrate import solve_ivp

    times, start = np.asarray(t, float), np.asarray(y0, float)
    fixed = dict(parameters or {})
    answer = solve_ivp(
        lambda time, state: np.asarray(rhs(time, state, **fixed), float),
        (times[0], times[-1]),
        start,
        method="DOP853",
        t_eval=times,
        rtol=max(rtol / 10, 1e-13),
        atol=max(rtol / 10, 1e-13) * (np.abs(start).max() + 1e-3),
    )
    if not answer.success:
        raise ArithmeticError(answer.message)
    states: Array = np.ascontiguousarray(answer.y.T)
    states[0] = start
    return states
