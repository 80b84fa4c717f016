"""What must not change along a motion, and how fast an error shrinks or grows."""

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["drift", "growth_exponent", "observed_order", "rotation_defect", "violation"]

Array = NDArray[np.float64]


def drift(invariant: Callable[[Any], Any], states: ArrayLike) -> Array:
    """How far an invariant has moved from its first value, relative to its largest magnitude.

    invariant : of one state; a number (an energy) or a vector (a momentum)
    states    : (n, k)
    Returns (n,); absolute where the invariant is zero throughout.
    """
    values = np.array([np.ravel(invariant(state)) for state in np.asarray(states)])
    largest = np.abs(values).max()
    if largest > 0:
        values = values / largest  # first, lest the squares of small ones vanish
        values = values / np.linalg.norm(values, axis=1).max()
    moved: Array = np.linalg.norm(values - values[0], axis=1)
    return moved


def violation(constraint: Callable[[Any], Any], states: ArrayLike) -> Array:
    """How far each state is from satisfying constraint(state) = 0, its largest component.

    states : (n, k)
    Returns (n,), in the constraint's own unit.
    """
    return np.array([np.abs(constraint(state)).max() for state in np.asarray(states)])


def rotation_defect(rotations: ArrayLike) -> Array:
    """Largest element of R^T R - I, of each matrix.

    rotations : (..., 3, 3)
    Returns (...).
    """
    R = np.asarray(rotations, dtype=float)
    defect: Array = np.abs(np.swapaxes(R, -1, -2) @ R - np.eye(3)).max(axis=(-1, -2))
    return defect


def observed_order(steps: ArrayLike, errors: ArrayLike) -> float:
    """p of error = C step^p, by least squares in the logarithms.

    steps, errors : (n,), positive, n >= 2; errors of rounding must not be among them
    ValueError if a step or an error is not positive.
    """
    return _slope("steps", steps, errors)


def growth_exponent(times: ArrayLike, errors: ArrayLike) -> float:
    """p of error = C t^p: 1/2 for accumulated rounding, 1 for a drift, 2 for the phase of a drifting energy.

    times  : (n,), positive
    errors : (n,), of any sign; each counts as the largest so far, so that a lucky zero does not
    ValueError if a time is not positive or all errors are zero at first.
    """
    return _slope("times", times, np.maximum.accumulate(np.abs(np.asarray(errors, dtype=float))))


def _slope(name: str, x: ArrayLike, y: ArrayLike) -> float:
    x, y = np.asarray(x, dtype=float), np.asarray(y, dtype=float)
    if len(x) != len(y) or len(x) < 2:
        raise ValueError(f"{name}, errors: need two or more of each, as many of one as of the other")
    if not (x > 0).all() or not (y > 0).all():
        raise ValueError(f"{name}, errors: must be positive, for their logarithms")
    return float(np.polyfit(np.log(x), np.log(y), 1)[0])
