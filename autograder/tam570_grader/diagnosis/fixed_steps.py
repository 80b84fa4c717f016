"""The classical Runge-Kutta method with fixed steps; known mistakes that import it get a copy of its source."""

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray


def runge_kutta(
    rates: Callable[[NDArray[np.float64]], ArrayLike], t: ArrayLike, start: ArrayLike, steps: ArrayLike
) -> NDArray[np.float64]:
    """Return the states at the times t; `steps` is the number of steps to each next time, or one number for all."""
    rows = [np.array(start, float)]
    spans = np.diff(np.asarray(t, float))
    for span, count in zip(spans, np.broadcast_to(steps, spans.shape), strict=True):
        y, h = rows[-1], span / count
        for _ in range(count):
            k1 = np.asarray(rates(y))
            k2 = np.asarray(rates(y + h / 2 * k1))
            k3 = np.asarray(rates(y + h / 2 * k2))
            y = y + h / 6 * (k1 + 2 * k2 + 2 * k3 + np.asarray(rates(y + h * k3)))
        rows.append(y)
    return np.array(rows)
