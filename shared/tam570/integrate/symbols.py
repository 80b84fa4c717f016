"""Numbers not known yet, and the tape on which what is done to them is recorded: the operations as a graph.

Each operation is recorded once, in the order of its first use, and simplified on the way: a factor of zero takes its
term along, a sum with zero is the other term.
"""

import functools
from collections.abc import Callable

import numpy as np

from tam570.values import Function, Numbers

__all__ = ["FUNCTIONS", "NUMPY_NAMES", "Symbol", "Tape", "Untraceable", "Value"]


class Untraceable(TypeError):
    """The function wants to know the value of a symbol."""


class Tape:
    """What was done to the symbols, each operation once, in the order of its first use."""

    def __init__(self) -> None:
        self.symbols: dict[tuple[Numbers, ...], Symbol] = {}

    def record(self, name: str, *arguments: Numbers) -> "Symbol":
        arguments = tuple(a if isinstance(a, Symbol) else float(a) for a in arguments)
        key = (name, *(("symbol", a.number) if isinstance(a, Symbol) else a for a in arguments))
        if key not in self.symbols:
            self.symbols[key] = Symbol(self, len(self.symbols), name, arguments)
        return self.symbols[key]


def _operator(combined: Callable[[Tape, Numbers, Numbers], Numbers], swapped: bool = False) -> Function:
    def method(self: "Symbol", other: Numbers) -> Numbers:
        if isinstance(other, np.ndarray):
            return NotImplemented  # NumPy goes through the elements
        return combined(self.tape, other, self) if swapped else combined(self.tape, self, other)

    return method


def _sum(tape: Tape, a: Numbers, b: Numbers) -> Numbers:
    if _is(a, 0) or _is(b, 0):
        return b if _is(a, 0) else a
    if isinstance(b, Symbol) and b.name == "neg":
        return _difference(tape, a, b.arguments[0])
    return tape.record("+", *_ordered(a, b))


def _difference(tape: Tape, a: Numbers, b: Numbers) -> Numbers:
    if _is(a, 0) or _is(b, 0):
        return -b if _is(a, 0) else a
    if isinstance(b, Symbol) and b.name == "neg":
        return _sum(tape, a, b.arguments[0])
    return tape.record("-", a, b)


def _product(tape: Tape, a: Numbers, b: Numbers) -> Numbers:
    for number, other in ((a, b), (b, a)):
        if _is(number, 0):
            return 0.0
        if _is(number, 1) or _is(number, -1):
            return other if _is(number, 1) else -other
    return tape.record("*", *_ordered(a, b))


def _quotient(tape: Tape, a: Numbers, b: Numbers) -> Numbers:
    if _is(a, 0):
        return 0.0
    return a if _is(b, 1) else tape.record("/", a, b)


def _power(tape: Tape, base: Numbers, exponent: Numbers) -> Numbers:
    """Small whole and half powers as products and a root: faster than pow, and no less accurate."""
    if isinstance(exponent, Symbol) or not float(2 * exponent).is_integer() or abs(exponent) > 8:
        return tape.record("pow", base, exponent)
    if exponent < 0:
        return _quotient(tape, 1.0, _power(tape, base, -exponent))
    root = tape.record("sqrt", base) if exponent % 1 else 1.0
    return functools.reduce(lambda product, _: product * base, range(int(exponent)), root)


def _is(value: Numbers, number: float) -> bool:
    return not isinstance(value, Symbol) and bool(value == number)


def _ordered(a: Numbers, b: Numbers) -> tuple[Numbers, Numbers]:
    """Order the terms: a + b is b + a, to the last bit."""
    first, second = (x.number if isinstance(x, Symbol) else -1 for x in (a, b))
    return (a, b) if first <= second else (b, a)


def _refuse(*_: Numbers) -> Numbers:
    raise Untraceable("depends on the value of the state")


class Symbol:
    """A number not known yet."""

    __slots__ = ("arguments", "name", "number", "tape")

    def __init__(self, tape: Tape, number: int, name: str, arguments: tuple[Numbers, ...]) -> None:
        self.tape, self.number, self.name, self.arguments = tape, number, name, arguments

    __add__, __radd__ = _operator(_sum), _operator(_sum, swapped=True)
    __sub__, __rsub__ = _operator(_difference), _operator(_difference, swapped=True)
    __mul__, __rmul__ = _operator(_product), _operator(_product, swapped=True)
    __truediv__, __rtruediv__ = _operator(_quotient), _operator(_quotient, swapped=True)
    __pow__, __rpow__ = _operator(_power), _operator(_power, swapped=True)

    def __neg__(self) -> Numbers:
        return self.arguments[0] if self.name == "neg" else self.tape.record("neg", self)

    def __pos__(self) -> Numbers:
        return self

    def __abs__(self) -> Numbers:
        return self.tape.record("fabs", self)

    def __getattr__(self, name: str) -> Function:
        """NumPy's functions ask an object for a method of their name."""
        if name not in FUNCTIONS:
            raise AttributeError(name)
        return functools.partial(self.tape.record, FUNCTIONS[name], self)

    __float__ = __int__ = __bool__ = __index__ = __round__ = __floor__ = __ceil__ = _refuse
    __lt__ = __le__ = __gt__ = __ge__ = __mod__ = __rmod__ = __floordiv__ = __rfloordiv__ = _refuse
    __eq__ = __ne__ = __hash__ = __str__ = __repr__ = __format__ = __complex__ = __trunc__ = _refuse


_NAMES = """sin cos tan asin acos atan atan2 sinh cosh tanh asinh acosh atanh
exp expm1 log log1p log2 log10 sqrt cbrt hypot fabs erf erfc"""
FUNCTIONS = {name: name for name in _NAMES.split()}
FUNCTIONS |= {"arc" + name[1:]: name for name in FUNCTIONS if name[0] == "a"} | {"absolute": "fabs"}
NUMPY_NAMES = {plain: name for name, plain in FUNCTIONS.items() if name.startswith("arc")} | {"pow": "power"}

Value = Symbol | float
