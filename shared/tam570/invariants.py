"""Measure how well a motion conserves invariants and satisfies constraints, and how fast an error shrinks or grows."""

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["drift", "growth_exponent", "observed_order", "rotation_defect", "violation"]

Array = NDArray[np.float64]


def drift(invariant: Callable[[Array], ArrayLike], states: ArrayLike) -> Array:
    """Measure how far an invariant moves from its first value, relative to its largest magnitude.

    Parameters
    ----------
    invariant : callable
        Takes one state; returns a number (an energy) or a vector (a momentum).
    states : (n, k) array_like

    Returns
    -------
    (n,) ndarray
        Absolute if the invariant is zero throughout.

    Examples
    --------
    >>> drift(lambda state: state[0] ** 2 + state[1] ** 2, [[1.0, 0.0], [0.0, 1.1]]).round(3)
    array([0.   , 0.174])
    """
    values = np.array([np.ravel(invariant(state)) for state in np.asarray(states)])
    largest = np.abs(values).max()
    if largest > 0:
        values = values / largest  # before the norm, so that squares of small values do not underflow
        values = values / np.linalg.norm(values, axis=1).max()
    return np.linalg.norm(values - values[0], axis=1)


def violation(constraint: Callable[[Array], ArrayLike], states: ArrayLike) -> Array:
    """Measure how far each state is from satisfying constraint(state) = 0, by its largest component.

    Parameters
    ----------
    constraint : callable
        Takes one state; returns a number or an array.
    states : (n, k) array_like

    Returns
    -------
    (n,) ndarray
        In the unit of the constraint.

    Examples
    --------
    >>> violation(lambda state: state[0] ** 2 + state[1] ** 2 - 1, [[1.0, 0.0], [0.0, 1.1]]).round(3)
    array([0.  , 0.21])
    """
    return np.array([np.abs(constraint(state)).max() for state in np.asarray(states)])


def rotation_defect(rotations: ArrayLike) -> Array:
    """Return the largest element of R^T R - I of each matrix.

    Parameters
    ----------
    rotations : (..., 3, 3) array_like

    Returns
    -------
    (...) ndarray

    Examples
    --------
    >>> round(float(rotation_defect(1.01 * np.eye(3))), 4)
    0.0201
    """
    R = np.asarray(rotations, dtype=float)
    return np.abs(np.swapaxes(R, -1, -2) @ R - np.eye(3)).max(axis=(-1, -2))


def observed_order(steps: ArrayLike, errors: ArrayLike) -> float:
    """Fit p of error = C step^p, by least squares in the logarithms.

    Parameters
    ----------
    steps, errors : (n,) array_like
        Positive, n >= 2. Leave out errors that are only rounding.

    Returns
    -------
    float

    Raises
    ------
    ValueError
        If a step or an error is not positive.

    Examples
    --------
    >>> round(observed_order([0.1, 0.05, 0.025], [1e-4, 6.25e-6, 3.90625e-7]), 9)
    4.0
    """
    return _slope("steps", steps, errors)


def growth_exponent(times: ArrayLike, errors: ArrayLike) -> float:
    """Fit p of error = C t^p: 1/2 for accumulated rounding, 1 for a drift, 2 for the phase of a drifting energy.

    Parameters
    ----------
    times : (n,) array_like
        Positive.
    errors : (n,) array_like
        Of any sign. Each is replaced by the largest so far, so that a lucky zero does not disturb the fit.

    Returns
    -------
    float

    Raises
    ------
    ValueError
        If a time is not positive, or the first error is zero.

    Examples
    --------
    >>> round(growth_exponent([1.0, 2.0, 4.0], [1e-9, 2e-9, 4e-9]), 9)
    1.0
    """
    return _slope("times", times, np.maximum.accumulate(np.abs(np.asarray(errors, dtype=float))))


def _slope(name: str, x: ArrayLike, y: ArrayLike) -> float:
    x, y = np.asarray(x, dtype=float), np.asarray(y, dtype=float)
    if len(x) != len(y) or len(x) < 2:
        raise ValueError(f"{name}, errors: need two or more of each, as many of one as of the other")
    if not (x > 0).all() or not (y > 0).all():
        raise ValueError(f"{name}, errors: must be positive, for their logarithms")
    return float(np.polyfit(np.log(x), np.log(y), 1)[0])
