"""The right-hand side as a function of time and state alone, checked; and its calls where it is called as it stands.

What rounding does to rates that are called is measured: they are taken at neighbouring floats of time and state. An
error estimate below the differences is the rounding's, not the method's. Where only those on one side are large, it is
a jump of the rates, and does not count.
"""

import inspect
import math
from collections.abc import Callable, Mapping, Sequence
from functools import lru_cache

import numpy as np

from tam570.integrate.arguments import Array, is_masked
from tam570.integrate.course import copy_of
from tam570.integrate.dop853 import ESTIMATE_ROUNDOFF
from tam570.values import Function, Numbers, Parameters

Rates = Callable[[float, Numbers], Numbers]
ROUNDED = 4.0  # units in the last place: the time of two calls is rounded in two ways
FEW_DIGITS = 8.0  # roundings of a rate: a smaller rtol asks for steps that follow them
PLAIN = {float, int, np.float64}
TRIAL_ERRORS = (ArithmeticError, ValueError, LookupError)  # a step that is too long may leave the domain


class RhsError(Exception):
    """The right-hand side does not return what it should: told as a ValueError, and by no shorter step."""


def bound(rhs: Function, parameters: Parameters | None, name: str = "rhs") -> Rates:
    """rhs(t, y) with the parameters in place. ValueError, with the name, where they do not fit its signature."""
    if not callable(rhs):
        raise ValueError(f"{name}: must be a function of (t, y, **parameters), got {type(rhs).__name__}")
    if parameters is not None and not isinstance(parameters, Mapping):
        raise ValueError(f"parameters: must be a mapping of names to values, got {type(parameters).__name__}")
    fixed = dict(parameters or {})
    try:
        problem = _misfit(rhs, tuple(fixed))
    except TypeError:  # it has no hash
        problem = _misfit.__wrapped__(rhs, tuple(fixed))
    if problem:
        raise ValueError(f"{name}: cannot be called with (t, y, **parameters): {problem}")
    if not fixed:
        return rhs
    return lambda t, y: rhs(t, y, **fixed)


def check_start(rates: Rates, t: float, y0: Array, sign: float) -> np.dtype[Numbers]:
    """Return the type of the numbers. sign : of the engine's clock.

    ValueError unless rhs gives as many finite real ones as y0 has.
    """
    value = rates(t, y0.copy())
    at_start, dtype = _checked(value, len(y0)), np.asarray(value).dtype
    repeated = _checked(rates(t, y0.copy()), len(y0))
    if not np.isfinite(at_start).all():
        raise ValueError(f"rhs: gives {at_start} at the start, t = {sign * t + 0.0:g}; is the start allowed?")
    if (at_start != repeated).any():
        raise ValueError(
            f"rhs: gives {at_start.tolist()} and then {repeated.tolist()} at the start; "
            "it must not be random, nor remember earlier calls"
        )
    return dtype


@lru_cache(maxsize=256)
def _misfit(rhs: Function, names: tuple[str, ...]) -> str:
    """Return why rhs does not take t, y and these keywords; empty if it does, or if it has no signature to look at."""
    try:
        inspect.signature(rhs).bind(0.0, None, **dict.fromkeys(names))
    except TypeError as problem:
        return str(problem)
    except ValueError:
        return ""
    return ""


class CalledRates:
    """Calls of rates(t, y) with arrays, as SciPy makes them: floats come back.

    dtype : of what the rates are at the start; error : the last one raised
    unused : a copy of the rates as they were before the first call
    """

    def __init__(self, rates: Rates, size: int) -> None:
        self.rates, self.size = rates, size
        self.dtype: np.dtype[Numbers] = np.dtype(float)
        self.unused = copy_of(rates)
        self.error: Exception | None = None

    def __call__(self, t: float, y: Sequence[float], c: Sequence[float] = ()) -> Sequence[float]:
        """Return the rates; there are no constants c."""
        try:
            value = self.rates(t, np.array(y))
        except TRIAL_ERRORS as error:
            self.error = error
            raise
        return _floats(value, self.size)

    def check_digits(self, rtol: float) -> None:
        """RhsError where all rates are of float32 or less, and fewer digits than are asked for."""
        rounding = float(np.finfo(self.dtype).eps) if self.dtype.kind == "f" and self.dtype.itemsize < 8 else 0.0
        if rtol < FEW_DIGITS * rounding:
            raise RhsError(
                f"rhs: returns {self.dtype.name}, whose rounding of {rounding:.1g} is more than rtol = {rtol:.1g} "
                f"allows; let it compute with float64, or give rtol = {FEW_DIGITS * rounding:.1g}"
            )

    def check_history(self, t: float, y: Array, span: float, rtol: float) -> None:
        """RhsError where the rates after a run of span, s, are not what they are without earlier calls."""
        try:
            self.rates(t, y * (1.0 - 2.0**-10))  # what it kept of that may come back
            f, g = np.array(self(t, tuple(y.tolist()))), _checked(copy_of(self.unused)(t, y.copy()), self.size)
        except Exception:  # some objects cannot be copied
            return
        change = np.abs(f - g).max()
        if change > rtol * np.abs(f).max() and span * change > rtol * np.abs(y).max():
            raise _memory_error(f.tolist(), g.tolist())

    def check_memory(self, t: float, y: Sequence[float], f: Sequence[float]) -> None:
        """RhsError where rates that were f are others now: the function is random, or remembers earlier calls."""
        g = self(t, y)
        changes = [abs(a - b) for a, b in zip(f, g, strict=True)]
        if all(x <= 1e-8 * max(abs(a), abs(b)) for x, a, b in zip(changes, f, g, strict=True)):
            return
        near = self(t - ROUNDED * math.ulp(t), y), self(t + ROUNDED * math.ulp(t), y)
        if any(x > max(abs(b - a) for b in there) for x, a, *there in zip(changes, g, *near, strict=True)):
            raise _memory_error(f, g)

    def roundoff(self, start: float, h: float, y: Numbers, f: Numbers, b: Numbers, _: Numbers) -> tuple[float, ...]:
        """Return what rounding does to the error estimates of a step of h."""
        self.check_memory(start, y, f)
        t, state = start + INSIDE * h, [v + INSIDE * h * rate for v, rate in zip(y, f, strict=True)]
        try:
            there, repeated = self(t, tuple(state)), self(t, tuple(state))
            if any(abs(a - b) > 0.0 for a, b in zip(there, repeated, strict=True)):
                raise _memory_error(there, repeated)
            above, below = (_changes(self, t, h, state, there, side) for side in (1.0, -1.0))
        except (ArithmeticError, ValueError, LookupError):
            return tuple(b)
        widths = (ESTIMATE_ROUNDOFF * h * _noise(*four) for four in zip(*above, *below, strict=True))
        return tuple(x if x < math.inf else 0.0 for x in widths)


def _memory_error(f: Sequence[float], g: Sequence[float]) -> RhsError:
    return RhsError(
        f"rhs: gives {list(f)} and {list(g)} for the same time and state; it must not be random, nor "
        "remember earlier calls. Put what it remembers into the state, or run it piece by piece"
    )


def _floats(value: Numbers, size: int) -> Sequence[float]:
    if type(value) is np.ndarray and value.dtype == float and value.shape == (size,):
        return value.tolist()  # type: ignore[no-any-return]
    if type(value) in (tuple, list) and len(value) == size:
        types = {*map(type, value)}
        if types == {float}:
            return value  # type: ignore[no-any-return]
        if types <= PLAIN:
            return [*map(float, value)]
    return _checked(value, size).tolist()  # type: ignore[no-any-return]


def is_same(rates: Rates, written: Function, constants: tuple[float, ...], times: Array, y0: Array) -> bool:
    """Return whether `written(t, y, constants)` gives what `rates` gives: at the start, and at points around it.

    Points that are not allowed are replaced by nearer ones, or left out: the answer is the code's, not the start's.
    """
    size = len(y0)
    for trial in range(3):
        t = float(times[-1 if trial % 2 else 0])
        away = np.sin(np.arange(1, size + 1) * (trial + 1.0) ** 2) * (trial > 0)
        for part in (0.3, 0.01, 1e-4):
            y = y0 + part * away * (1 + np.abs(y0))
            try:
                expected = _checked(rates(t, y.copy()), size)
                break
            except TRIAL_ERRORS:
                continue
        else:
            continue
        values = np.array(written(t, tuple(y.tolist()), constants))
        rounding = 1e-11 * max(np.abs(expected).max(), 1e-300)  # the order of operations differs
        if not (np.abs(values - expected) <= rounding).all() and np.isfinite(expected).all():
            return False
    return True


def _checked(value: Numbers, size: int) -> Array:
    try:
        rates_array = np.asarray(value)
    except ValueError as problem:  # rows of several lengths
        raise RhsError(f"rhs: must return {size} numbers, got {value!r}") from problem
    if rates_array.shape != (size,):
        returned = f"shape {rates_array.shape}" if rates_array.shape else f"one {type(value).__name__}"
        raise RhsError(f"rhs: must return {size} numbers, as many as y0 has, got {returned}")
    if is_masked(value):
        raise RhsError(f"rhs: must return numbers, got masked ones: {value!r}")
    if np.iscomplexobj(rates_array):
        raise RhsError(f"rhs: must return real numbers, got {rates_array}")
    if rates_array.dtype == object and None in rates_array.tolist():
        raise RhsError(f"rhs: must return numbers, got {value!r}")
    try:
        return rates_array.astype(float)
    except (TypeError, ValueError) as problem:
        raise RhsError(f"rhs: must return numbers, got {value!r}") from problem


EPS = 2.0**-52
PASSED_ON = 0.3  # of a step, after which the later stages see what rounding did to the earlier ones
ULPS = (1.37, 2.91, 5.3)  # by which a state is changed, times the pattern below: several, as one may round to nothing
PATTERN = (1.0, -1.41, 1.82, -1.0, 1.41, -1.82)  # no two components cancel
INSIDE = 0.4637  # of the step, where they are taken: no point at which a motion is likely to meet a jump
ONE_SIDED = 1e-3  # of the changes on one side, where those on the other are less: it is a jump

Changes = tuple[list[float], list[float]]  # the least and the largest of each rate


def _noise(least: float, largest: float, other_least: float, other_largest: float) -> float:
    if largest < ONE_SIDED * other_least or other_largest < ONE_SIDED * least:
        return min(largest, other_largest)
    return max(largest, other_largest)


def _changes(
    rates: Callable[[float, Numbers], Sequence[float]], t: float, h: float, y: list[float], f: Numbers, side: float
) -> Changes:
    """Of each rate, on one side; what it does to the state within h is passed on to the next change."""
    least, largest, moved = [math.inf] * len(y), [0.0] * len(y), [0.0] * len(y)
    for ulps in ULPS:
        near = [
            v + side * ulps * PATTERN[i % 6] * EPS * abs(v) + d for i, (v, d) in enumerate(zip(y, moved, strict=True))
        ]
        changes = [g - rate for g, rate in zip(rates(t + side * ulps * EPS * abs(t), tuple(near)), f, strict=True)]
        least = [min(size, abs(change)) for size, change in zip(least, changes, strict=True)]
        largest = [max(size, abs(change)) for size, change in zip(largest, changes, strict=True)]
        moved = [PASSED_ON * h * change for change in changes]
    return least, largest
