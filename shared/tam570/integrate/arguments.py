"""Validates arguments of the solvers; each error message names the argument."""

import math
import sys
from numbers import Real

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tam570.integrate.error_scale import NO_SCALE
from tam570.values import Numbers

Array = NDArray[np.float64]

SMALLEST_RTOL = 1e-16  # below it only round-off remains


def checked(t: ArrayLike, y0: ArrayLike, rtol: float, atol: ArrayLike | None) -> tuple[Numbers, ...]:
    """Return times and their sign as by `sample_times`, the start, and the control of the steps."""
    from tam570.integrate.adaptive import Control

    (times, sign), start, of_step = sample_times(t), initial_state(y0), of_one_step(tolerance(rtol))
    return times, sign, start, Control(of_step, allowed_error(atol, start.shape[-1]))


def positive(name: str, value: Numbers) -> float:
    """Return a positive number, which may be infinite; raise ValueError with `name` if it is not one."""
    if not isinstance(value, float | int | np.floating | np.integer) or not value > 0:
        raise ValueError(f"{name}: must be a number above zero, got {value!r}")
    return float(value)


def sample_times(t: ArrayLike) -> tuple[Array, float]:
    """Return (n,) increasing times and a sign: -1 if the times in `t` decrease and were negated.

    Raise ValueError unless `t` has at least two finite times, strictly increasing or decreasing.
    """
    times = _array("t", t, "a list of numbers")
    if times.ndim != 1 or len(times) < 2:
        raise ValueError(f"t: need a list of two or more times, got shape {times.shape}; try np.linspace(0, 10, 101)")
    sign = -1.0 if times[1] < times[0] else 1.0
    times = times if sign > 0 else 0.0 - times
    steps = times[1:] - times[:-1]
    if not (steps.min() > 0 and times[-1] - times[0] < math.inf):
        if not np.isfinite(times).all():
            raise ValueError("t: a time is infinite or not a number")
        where = int(np.argmin(steps > 0))
        verb, relation = ("increase", "exceed") if sign > 0 else ("decrease", "come before")
        later = f"t[{where + 1}] = {sign * times[where + 1]:g}"
        raise ValueError(f"t: must {verb}, but {later} does not {relation} t[{where}]")
    return times, sign


def _array(name: str, value: ArrayLike, numbers: str) -> Array:
    if is_masked(value):
        raise ValueError(f"{name}: every number must be known, got masked ones: {value!r}")
    try:
        return np.array(value, dtype=float)
    except (TypeError, ValueError, OverflowError) as problem:
        raise ValueError(f"{name}: must be {numbers} ({problem})") from problem


def initial_state(y0: ArrayLike) -> Array:
    """Return (k,) or (m, k) floats. Raise ValueError if y0 is empty, complex, not finite or of another shape."""
    try:
        is_complex = np.iscomplexobj(np.asarray(y0))
    except ValueError:  # rows of different lengths
        is_complex = False
    if is_complex:
        raise ValueError("y0: must be real; it is complex: give real and imaginary parts as components of their own")
    state = _array("y0", y0, "a flat list of real numbers")
    if state.ndim == 2 and state.shape[1] == 1 and state.shape[0] > 1:
        raise ValueError(
            f"y0: a column of shape {state.shape} is one component of {len(state)} starts; for one start give "
            "y0.ravel(), for many starts of one component solve them in a loop"
        )
    if state.ndim not in (1, 2) or state.size == 0:
        raise ValueError(f"y0: need k numbers, or (m, k) for m starts at once, got shape {state.shape}")
    if not math.isfinite(sum(state.ravel().tolist())) and not np.isfinite(state).all():
        raise ValueError(f"y0: every number must be finite, got {state}")
    return state


def is_masked(value: ArrayLike) -> bool:
    """Return whether a masked array has masked elements; without importing numpy.ma, which takes time."""
    masked_arrays = sys.modules.get("numpy.ma")
    return masked_arrays is not None and bool(masked_arrays.is_masked(value))


def tolerance(rtol: float) -> float:
    """Return rtol as a float. Raise ValueError unless 0 < rtol < 1."""
    if not isinstance(rtol, Real) or not 0 < rtol < 1:
        raise ValueError(f"rtol: need 0 < rtol < 1, got {rtol!r}; 1e-10 is a good start")
    return float(rtol)


def of_one_step(rtol: float) -> float:
    """Return the tolerance of a step: below 1e-13 it decreases as rtol**3, because the errors of the steps add up."""
    return max(min(rtol, rtol**3 * 1e26), SMALLEST_RTOL)


def allowed_error(atol: ArrayLike | None, size: int) -> tuple[float, ...]:
    """Return k absolute tolerances, or () for None. Raise ValueError unless atol is one or k numbers, none negative."""
    if atol is None:
        return ()
    allowed = _array("atol", atol, "one number, or one a component")
    if allowed.shape not in ((), (size,)):
        raise ValueError(f"atol: need one number, or {size}, one a component; got shape {allowed.shape}")
    if not (np.isfinite(allowed).all() and (allowed >= 0).all()):
        raise ValueError(f"atol: must be finite and not negative, got {allowed}")
    return tuple(max(float(error), NO_SCALE) for error in np.broadcast_to(allowed, size))
