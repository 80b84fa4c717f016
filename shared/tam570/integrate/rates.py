"""Validates a right-hand side as a function of time and state, and calls it if it cannot be traced.

The round-off of called rates is measured: they are evaluated at neighboring floats of time and state. An error estimate
below the differences is round-off, not an error of the method. If the differences are large on only one side, the rates
have a jump there, which is not round-off.
"""

import inspect
import math
from collections.abc import Callable, Mapping, Sequence

import numpy as np

from tam570.integrate.arguments import Array, is_masked
from tam570.integrate.course import copy_of
from tam570.integrate.dop853 import ESTIMATE_ROUNDOFF
from tam570.values import Function, Numbers, Parameters

Rates = Callable[[float, Numbers], Numbers]
ROUNDED = 4.0  # units in the last place of t, because two calls may round the same time differently
FEW_DIGITS = 8.0  # smallest rtol in units of the round-off of the rates; below it, steps would resolve round-off
PLAIN = {float, int, np.float64}
SHORT, CONSTANTS = (np.float32, np.float16), 10  # values of such types; more different ones are no constants
TRIAL_ERRORS = (ArithmeticError, ValueError, LookupError)  # a step that is too long may leave the domain


class RhsError(Exception):
    """Raised for invalid values of the right-hand side, which no shorter step can avoid; becomes a ValueError."""


def bound(rhs: Function, parameters: Parameters | None, name: str = "rhs") -> Rates:
    """Return rhs(t, y) with bound parameters; raise ValueError, with `name`, if they do not fit its signature."""
    if not callable(rhs):
        raise ValueError(f"{name}: must be a function of (t, y, **parameters), got {type(rhs).__name__}")
    if parameters is not None and not isinstance(parameters, Mapping):
        raise ValueError(f"parameters: must be a mapping of names to values, got {type(parameters).__name__}")
    fixed = dict(parameters or {})
    try:
        inspect.signature(rhs).bind(0.0, None, **fixed)
    except TypeError as problem:
        raise ValueError(f"{name}: cannot be called with (t, y, **parameters): {problem}") from None
    except ValueError:  # it has no signature
        pass
    if not fixed:
        return rhs
    return lambda t, y: rhs(t, y, **fixed)


def check_start(rates: Rates, t: float, y0: Array, sign: float) -> None:
    """Raise ValueError or RhsError unless rhs returns as many finite real numbers as y0 has, twice the same.

    sign : -1 if the engine's time is -t
    """
    try:
        at_start, repeated = (_checked(rates(t, y0.copy()), len(y0)) for _ in range(2))
    except Exception as error:
        if not isinstance(error, RhsError):
            error.add_note(f"solve: rhs raises this at the start, t = {sign * t + 0.0:g}, y = {y0.tolist()}")
        raise
    if not np.isfinite(at_start).all():
        raise ValueError(f"rhs: gives {at_start} at the start, t = {sign * t + 0.0:g}; is the start allowed?")
    if (at_start != repeated).any():
        raise ValueError(
            f"rhs: gives {at_start.tolist()} and then {repeated.tolist()} at the start; "
            "it must not be random, nor remember earlier calls"
        )


class CalledRates:
    """Calls rates(t, y) with arrays, as SciPy does, and returns floats.

    error : the last exception that they raised; unused : a copy of the rates from before the first call
    rtol : of the run; short : the different float32 or float16 values in the rates so far
    """

    def __init__(self, rates: Rates, size: int) -> None:
        self.rates, self.size = rates, size
        self.begin(math.inf)
        self.unused = copy_of(rates)
        self.error: Exception | None = None

    def __call__(self, t: float, y: Sequence[float], c: Sequence[float] = ()) -> Sequence[float]:
        """Return the rates; c is unused, as in the signature of traced rates."""
        try:
            value = self.rates(t, np.array(y))
        except TRIAL_ERRORS as error:
            self.error = error
            raise
        plain = _plain(value, self.size)
        if plain is not None:
            return plain
        checked = _checked(value, self.size)
        self._check_digits(value)
        return checked.tolist()  # type: ignore[no-any-return]

    def begin(self, rtol: float) -> None:
        """Reset for a new run."""
        self.rtol = rtol
        self.short: set[tuple[float, ...]] = set()

    def _check_digits(self, value: Numbers) -> None:
        """Raise RhsError if some rates are float32 or float16, with too few digits for rtol, and no constants."""
        short = [rate for rate in map(np.asarray, value) if rate.dtype in SHORT]
        rounding, name = max(((float(np.finfo(rate.dtype).eps), rate.dtype.name) for rate in short), default=(0.0, ""))
        if self.rtol >= FEW_DIGITS * rounding:
            return
        self.short.add(tuple(map(float, short)))
        if len(self.short) > CONSTANTS:
            raise RhsError(
                f"rhs: returns {name}, whose rounding of {rounding:.1g} is more than rtol = {self.rtol:.1g} "
                f"allows; let it compute with float64, or give rtol = {FEW_DIGITS * rounding:.1g}"
            )

    def check_history(self, t: float, y: Array, span: float, rtol: float) -> None:
        """Raise RhsError if the rates after a run of `span`, s, depend on earlier calls."""
        try:
            self.rates(t, y * (1.0 - 2.0**-10))  # a function with memory may now return values of this call
            f, g = np.array(self(t, tuple(y.tolist()))), _checked(copy_of(self.unused)(t, y.copy()), self.size)
        except Exception:  # some objects cannot be copied
            return
        change = np.abs(f - g).max()
        if change > rtol * np.abs(f).max() and span * change > rtol * np.abs(y).max():
            raise _memory_error(f.tolist(), g.tolist())

    def check_memory(self, t: float, y: Sequence[float], f: Sequence[float]) -> None:
        """Raise RhsError if the rates are no longer f: the function is random, or remembers earlier calls."""
        g = self(t, y)
        changes = [abs(a - b) for a, b in zip(f, g, strict=True)]
        if all(x <= 1e-8 * max(abs(a), abs(b)) for x, a, b in zip(changes, f, g, strict=True)):
            return
        near = self(t - ROUNDED * math.ulp(t), y), self(t + ROUNDED * math.ulp(t), y)
        if any(x > max(abs(b - a) for b in there) for x, a, *there in zip(changes, g, *near, strict=True)):
            raise _memory_error(f, g)

    def roundoff(self, start: float, h: float, y: Numbers, f: Numbers, b: Numbers, _: Numbers) -> tuple[float, ...]:
        """Return the round-off of the error estimates of a step of h; b if the rates cannot be evaluated."""
        self.check_memory(start, y, f)
        t, state = start + INSIDE * h, [v + INSIDE * h * rate for v, rate in zip(y, f, strict=True)]
        try:
            there, repeated = self(t, tuple(state)), self(t, tuple(state))
            if any(abs(a - b) > 0.0 for a, b in zip(there, repeated, strict=True)):
                raise _memory_error(there, repeated)
            above, below = (_changes(self, t, h, state, there, side) for side in (1.0, -1.0))
        except TRIAL_ERRORS:
            return tuple(b)
        widths = (ESTIMATE_ROUNDOFF * h * _noise(*four) for four in zip(*above, *below, strict=True))
        return tuple(x if x < math.inf else 0.0 for x in widths)


def _memory_error(f: Sequence[float], g: Sequence[float]) -> RhsError:
    return RhsError(
        f"rhs: gives {list(f)} and {list(g)} for the same time and state; it must not be random, nor "
        "remember earlier calls. Put what it remembers into the state, or run it piece by piece"
    )


def _plain(value: Numbers, size: int) -> Sequence[float] | None:
    """Return the rates as floats if their types need no check, else None."""
    if type(value) is np.ndarray and value.dtype == float and value.shape == (size,):
        return value.tolist()  # type: ignore[no-any-return]
    if type(value) in (tuple, list) and len(value) == size:
        types = {*map(type, value)}
        if types == {float}:
            return value  # type: ignore[no-any-return]
        if types <= PLAIN:
            return [*map(float, value)]
    return None


def is_same(rates: Rates, written: Function, constants: tuple[float, ...], times: Array, y0: Array) -> bool:
    """Return whether `written(t, y, constants)` equals `rates(t, y)` at the start and at points around it.

    Points at which `rates` raises an error are replaced by closer ones, or skipped.
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
        rounding = 1e-11 * max(np.abs(expected).max(), 1e-300)  # the order of operations may differ
        if not (np.abs(values - expected) <= rounding).all() and np.isfinite(expected).all():
            return False
    return True


def _checked(value: Numbers, size: int) -> Array:
    try:
        rates_array = np.asarray(value)
    except ValueError as problem:  # rows of different lengths
        raise RhsError(f"rhs: must return {size} numbers, got {value!r}") from problem
    if rates_array.shape != (size,):
        returned = f"shape {rates_array.shape}" if rates_array.shape else f"one {type(value).__name__}"
        raise RhsError(f"rhs: must return {size} numbers, as many as y0 has, got {returned}")
    if is_masked(value):
        raise RhsError(f"rhs: must return numbers, got masked ones: {value!r}")
    if np.iscomplexobj(rates_array):
        raise RhsError(f"rhs: must return real numbers, got {rates_array}")
    if rates_array.dtype.kind in "USO" and any(isinstance(rate, str | bytes | None) for rate in rates_array.tolist()):
        raise RhsError(f"rhs: must return numbers, got {value!r}")
    try:
        return rates_array.astype(float)
    except (TypeError, ValueError) as problem:
        raise RhsError(f"rhs: must return numbers, got {value!r}") from problem


EPS = 2.0**-52
PASSED_ON = 0.3  # of a step, in which round-off of earlier stages affects later ones
ULPS = (1.37, 2.91, 5.3)  # changes of the state, times PATTERN; several, since one may round to no change
PATTERN = (1.0, -1.41, 1.82, -1.0, 1.41, -1.82)  # unequal, so that no two components cancel
INSIDE = 0.4637  # of the step, where round-off is measured: a point at which a jump is unlikely
ONE_SIDED = 1e-3  # ratio of the changes on both sides that indicates a jump

Changes = tuple[list[float], list[float]]  # smallest and largest change of each rate


def _noise(least: float, largest: float, other_least: float, other_largest: float) -> float:
    if largest < ONE_SIDED * other_least or other_largest < ONE_SIDED * least:
        return min(largest, other_largest)
    return max(largest, other_largest)


def _changes(
    rates: Callable[[float, Numbers], Sequence[float]], t: float, h: float, y: list[float], f: Numbers, side: float
) -> Changes:
    """Return the changes of the rates on one side; each also shifts the state for the next, as in stages of a step."""
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
