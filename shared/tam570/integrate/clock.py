"""A time that notes at which other times the function that is given it may do something else.

A `Clock` is a float. What is affine in it is a `Clock` again; where that is compared with a number, rounded, reduced
by a period or looked up in a table, the time at which the answer changes is noted. So is the time at which it is zero:
`exp(-((t - 5) / 0.02)**2)` is a pulse at 5 that every step may pass. A run steps onto the times that were noted.
"""

import math
import operator
from collections.abc import Callable
from numbers import Real
from typing import Any

import numpy as np

__all__ = ["Clock"]

ARITHMETIC: dict[Any, Callable[..., Any]] = {
    np.add: operator.add,
    np.subtract: operator.sub,
    np.multiply: operator.mul,
    np.true_divide: operator.truediv,
    np.negative: operator.neg,
    np.absolute: abs,
    np.fabs: abs,
    np.remainder: operator.mod,
    np.less: operator.lt,
    np.less_equal: operator.le,
    np.greater: operator.gt,
    np.greater_equal: operator.ge,
    np.equal: operator.eq,
    np.not_equal: operator.ne,
}
LEVELS = {"maximum", "minimum", "fmax", "fmin", "clip", "heaviside", "sign"}  # ufuncs that change at their arguments
ROUNDINGS = {"floor", "ceil", "trunc", "rint", "floor_divide", "fmod"}
TABLES = {"interp": 1, "searchsorted": 0, "digitize": 1}  # NumPy's functions of a table, and which argument it is
FEW = 10_000  # knots of a table


def _compared(compare: Callable[[Any, Any], Any]) -> Callable[["Clock", Any], Any]:
    def method(self: "Clock", other: Any) -> Any:
        if isinstance(other, np.ndarray):
            self.note_levels(other)
            return compare(self.value, other)
        if not isinstance(other, Real):
            return NotImplemented
        self.record(other)
        return compare(self.value, float(other))

    return method


def _is_number(other: Any) -> bool:
    return isinstance(other, Real) and not isinstance(other, Clock)


class Clock(float):
    """The number rate * t + shift. seen : the times that are noted."""

    __slots__ = ("rate", "seen", "shift", "value")
    rate: float
    shift: float
    seen: list[float]
    value: float

    def __new__(cls, value: float, rate: float, shift: float, seen: list[float]) -> "Clock":
        clock = super().__new__(cls, value)
        clock.value, clock.rate, clock.shift, clock.seen = value, rate, shift, seen
        return clock

    def record(self, level: Any) -> None:
        """Note when this reaches a number, or another clock."""
        rate, shift = (self.rate - level.rate, level.shift) if isinstance(level, Clock) else (self.rate, float(level))
        if rate:
            self.seen.append((shift - self.shift) / rate)

    def note_levels(self, levels: Any) -> None:
        """Note when this reaches the next numbers of a table, above and below."""
        table = np.sort(np.asarray(levels, dtype=float).ravel()[:FEW])
        position = int(np.searchsorted(table, self.value))
        for level in table[max(position - 1, 0) : position + 2]:
            self.record(level)

    def _affine(self, value: float, rate: float, shift: float) -> "Clock":
        clock = Clock(value, rate, shift, self.seen)
        clock.record(0.0)
        return clock

    def __add__(self, other: Any) -> Any:
        if isinstance(other, Clock):
            return self._affine(self.value + other.value, self.rate + other.rate, self.shift + other.shift)
        if _is_number(other):
            return self._affine(self.value + float(other), self.rate, self.shift + float(other))
        return float.__add__(self, other)

    __radd__ = __add__

    def __sub__(self, other: Any) -> Any:
        if isinstance(other, Clock):
            return self._affine(self.value - other.value, self.rate - other.rate, self.shift - other.shift)
        if _is_number(other):
            return self._affine(self.value - float(other), self.rate, self.shift - float(other))
        return float.__sub__(self, other)

    def __rsub__(self, other: Any) -> Any:
        return (-self) + other if _is_number(other) else float.__rsub__(self, other)

    def __mul__(self, other: Any) -> Any:
        if _is_number(other):
            factor = float(other)
            return Clock(self.value * factor, self.rate * factor, self.shift * factor, self.seen)
        return float.__mul__(self, other)

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Any:
        if _is_number(other) and other:
            divisor = float(other)
            return Clock(self.value / divisor, self.rate / divisor, self.shift / divisor, self.seen)
        return float.__truediv__(self, other)

    def __neg__(self) -> "Clock":
        return Clock(-self.value, -self.rate, -self.shift, self.seen)

    def __pos__(self) -> "Clock":
        return self

    def __abs__(self) -> "Clock":
        self.record(0.0)
        return -self if self.value < 0 else self

    def __mod__(self, period: Any) -> Any:
        if not (_is_number(period) and period):
            return float.__mod__(self, period)
        turns = self.value // float(period)
        self.record(turns * period)
        self.record((turns + 1) * period)
        return self._affine(self.value % float(period), self.rate, self.shift - turns * float(period))

    def __floordiv__(self, period: Any) -> Any:
        if _is_number(period) and period:
            (self / period).note_wholes()
        return float.__floordiv__(self, period)

    def __divmod__(self, period: Any) -> Any:
        return self // period, self % period

    def note_wholes(self, half: float = 0.0) -> None:
        """Note when the nearest whole numbers are reached, or the halves beside them."""
        integer = math.floor(self.value - half) + half
        self.record(integer)
        self.record(integer + 1)

    def __floor__(self) -> int:
        self.note_wholes()
        return math.floor(self.value)

    def __ceil__(self) -> int:
        self.note_wholes()
        return math.ceil(self.value)

    def __trunc__(self) -> int:
        self.note_wholes()
        return math.trunc(self.value)

    __int__ = __trunc__

    def __round__(self, digits: Any = None) -> Any:
        (self * 10.0 ** (digits or 0)).note_wholes(0.5)
        return round(self.value, digits)

    def __bool__(self) -> bool:
        self.record(0.0)
        return bool(self.value)

    __lt__, __le__ = _compared(operator.lt), _compared(operator.le)
    __gt__, __ge__ = _compared(operator.gt), _compared(operator.ge)
    __eq__, __ne__ = _compared(operator.eq), _compared(operator.ne)
    __hash__ = float.__hash__

    def __reduce_ex__(self, _: Any) -> Any:
        return float, (self.value,)

    def __array_ufunc__(self, ufunc: Any, method: str, *arguments: Any, **keywords: Any) -> Any:
        clocks = [x for x in arguments if isinstance(x, Clock)]
        if (
            method == "__call__"
            and not keywords
            and ufunc in ARITHMETIC
            and all(isinstance(x, Real) for x in arguments)
        ):
            return ARITHMETIC[ufunc](*(x if isinstance(x, Clock) else float(x) for x in arguments))
        if ufunc.__name__ in LEVELS or ufunc in ARITHMETIC:
            for clock in clocks:
                clock.record(0.0)
                for other in arguments:
                    if other is not clock:
                        clock.note_levels(other)
        elif ufunc.__name__ in ROUNDINGS:
            for clock in clocks:
                (clock / arguments[1] if len(arguments) > 1 and _is_number(arguments[1]) else clock).note_wholes(
                    0.5 if ufunc is np.rint else 0.0
                )
        return getattr(ufunc, method)(*(_plain(x) for x in arguments), **{k: _plain(v) for k, v in keywords.items()})

    def __array_function__(self, function: Any, types: Any, arguments: Any, keywords: Any) -> Any:
        position = TABLES.get(function.__name__)
        if position is not None and len(arguments) > 1:
            for x in arguments:
                if isinstance(x, Clock):
                    x.note_levels(arguments[position])
        return function(*(_plain(x) for x in arguments), **{k: _plain(v) for k, v in keywords.items()})


def _plain(value: Any) -> Any:
    if isinstance(value, Clock):
        return value.value
    return type(value)(_plain(x) for x in value) if type(value) in (list, tuple) else value
