"""The right-hand side as a function of time and state alone, of plain floats where it can be, checked."""

import inspect
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import lru_cache
from typing import Any

import numpy as np

from tam570.integrate.arguments import Array

__all__ = ["Rates", "agrees", "bound", "check_start", "floats_function", "reversed_rates"]

Rates = Callable[[float, Any], Any]


def bound(rhs: Callable[..., Any], parameters: Mapping[str, Any] | None, name: str = "rhs") -> Rates:
    """rhs(t, y) with the parameters in place. ValueError, with the name, where they do not fit its signature."""
    if not callable(rhs):
        raise ValueError(f"{name}: must be a function of (t, y, **parameters), got {type(rhs).__name__}")
    fixed = dict(parameters or {})
    problem = _misfit(rhs, tuple(fixed))
    if problem:
        raise ValueError(f"{name}: cannot be called with (t, y, **parameters): {problem}")
    if not fixed:
        return rhs
    return lambda t, y: rhs(t, y, **fixed)


def reversed_rates(rates: Rates) -> Rates:
    """The rates of the motion that runs back: with -t for the time."""
    return lambda t, y: [-rate for rate in rates(-t, y)]


def check_start(rates: Rates, t: float, y0: Array, sign: float) -> None:
    """ValueError unless rhs gives as many finite real numbers as y0 has; sign : of the engine's clock."""
    found = _checked(rates(t, y0.copy()), len(y0))
    if not np.isfinite(found).all():
        raise ValueError(f"rhs: gives {found} at the start, t = {sign * t:g}; is the start allowed?")


@lru_cache(maxsize=256)
def _misfit(rhs: Callable[..., Any], names: tuple[str, ...]) -> str:
    """Why rhs does not take t, y and these keywords; empty if it does, or if it has no signature to look at."""
    try:
        inspect.signature(rhs).bind(0.0, None, **dict.fromkeys(names))
    except TypeError as problem:
        return str(problem)
    except ValueError:
        return ""
    return ""


def floats_function(rates: Rates, t: float, y0: Array) -> Rates:
    """`rates` as a function from a tuple of floats to a sequence of floats.

    Whether it may be given the tuple, or needs an array, is tried here, once: it may if both give the same.
    """
    nearby = y0 * 1.01 + 0.01
    if _same_on_tuples(rates, t, y0) and _same_on_tuples(rates, t, nearby):
        return _to_floats(rates, rates(t, tuple(y0.tolist())), tuple)
    return _to_floats(rates, rates(t, y0.copy()), np.array)


def agrees(rates: Rates, written: Callable[..., Any], constants: tuple[float, ...], times: Array, y0: Array) -> bool:
    """Whether `written(t, y, constants)` gives what `rates` gives: at the start, and at points all around it."""
    size = len(y0)
    for trial in range(3):
        away = 0.3 * np.sin(np.arange(1, size + 1) * (trial + 1.0) ** 2) if trial else np.zeros(size)
        t, y = float(times[-1 if trial % 2 else 0]), y0 + away * (1 + np.abs(y0))
        expected = _checked(rates(t, y.copy()), size)
        found = np.array(written(t, tuple(y.tolist()), constants))
        rounding = 1e-11 * max(np.abs(expected).max(), 1e-300)  # the order of operations differs
        if not (np.abs(found - expected) <= rounding).all() and np.isfinite(expected).all():
            return False
    return True


def _checked(value: Any, size: int) -> Array:
    found = np.asarray(value)
    if found.shape != (size,):
        raise ValueError(f"rhs: must return {size} numbers, as many as y0 has, got shape {found.shape}")
    if np.iscomplexobj(found):
        raise ValueError(f"rhs: must return real numbers, got {found}")
    try:
        return found.astype(float)
    except (TypeError, ValueError) as problem:
        raise ValueError(f"rhs: must return numbers, got {value!r}") from problem


def _same_on_tuples(rates: Rates, t: float, y: Array) -> bool:
    try:
        given_tuple = np.asarray(rates(t, tuple(y.tolist())), dtype=float)
        given_array = np.asarray(rates(t, y.copy()), dtype=float)
    except Exception:  # whatever a function says to a tuple, it then gets an array
        return False
    return given_tuple.shape == given_array.shape and bool(
        np.allclose(given_tuple, given_array, rtol=1e-12, atol=1e-300, equal_nan=True)
    )


def _to_floats(rates: Rates, sample: Any, wrap: Callable[[Sequence[float]], Any]) -> Rates:
    """`rates` made to take and to give plain floats; a NumPy scalar in the loop would cost ten times as much."""
    if wrap is tuple and isinstance(sample, (tuple, list)) and _plain(sample):
        return rates
    if isinstance(sample, np.ndarray) and sample.dtype == float:
        return lambda t, y: rates(t, wrap(y)).tolist()
    return lambda t, y: [float(rate) for rate in rates(t, wrap(y))]


def _plain(values: Iterable[Any]) -> bool:
    return all(type(value) is float for value in values)
