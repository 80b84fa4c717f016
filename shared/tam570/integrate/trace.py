"""A right-hand side specialised to its scene: call it once with symbols instead of numbers, write down what it did.

Parameters are numbers already, so what depends on them alone is computed here and now; a factor of zero takes its
term along; what occurs twice is computed once. A function that asks what a number is (a comparison, a loop until
convergence, a compiled routine) cannot be written down like this and is called as it stands.
"""

import functools
import math
import types
from collections.abc import Callable
from typing import Any

import numpy as np

from tam570.integrate.source import Formulas

__all__ = ["FUNCTIONS", "Untraceable", "halves", "traced"]

LONGEST = 200  # characters of one expression: brackets in brackets have a limit


class Untraceable(TypeError):
    """The function wants to know the value of a symbol."""


def traced(rates: Callable[..., Any], size: int) -> tuple[Formulas, tuple[float, ...]]:
    """What rates(t, y) computes, as source, and the constants in it. Raises Untraceable, or what rates raises."""
    constants: dict[float, str] = {}
    formulas = _written(*_called(rates, size), constants)
    return formulas, tuple(constants)


def halves(rates: Callable[..., Any], size: int) -> tuple[Formulas, Formulas, tuple[float, ...]]:
    """The rates of the first half of the state and those of the second, and the constants of both."""
    tape, values = _called(rates, size)
    constants: dict[float, str] = {}
    _written(tape, values, constants)
    first, second = values[: size // 2], values[size // 2 :]
    return _written(tape, first, constants), _written(tape, second, constants), tuple(constants)


def _called(rates: Callable[..., Any], size: int) -> tuple["Tape", list[Any]]:
    tape = Tape()
    time, state = tape.record("t"), [tape.record(f"s{i}") for i in range(size)]
    values = _translated(rates, {})(time, np.array(state))
    return tape, [v if isinstance(v, Symbol) else float(v) for v in values]


def _written(tape: "Tape", values: list[Any], constants: dict[float, str]) -> Formulas:
    uses = _uses(tape, values)
    texts: dict[int, str] = {}
    lines: list[str] = []

    def text(value: Any) -> str:
        if isinstance(value, Symbol):
            return texts[value.number]
        return constants.setdefault(value, f"c{len(constants)}") if value else "0.0"

    for symbol in tape.symbols.values():
        if not uses[symbol.number]:
            continue
        written = _written_operation(symbol.name, [text(a) for a in symbol.arguments])
        texts[symbol.number] = written
        if symbol.arguments and (uses[symbol.number] > 1 or len(written) > LONGEST):
            texts[symbol.number] = f"v{len(lines)}"
            lines.append(f"v{len(lines)} = {written}")
    rates = tuple(text(value) for value in values)
    used = [symbol.name for symbol in tape.symbols.values() if uses[symbol.number] and not symbol.arguments]
    reads = frozenset(int(name[1:]) for name in used if name != "t")
    return Formulas(tuple(lines), rates, len(constants), reads, "t" in used)


def _uses(tape: "Tape", values: list[Any]) -> list[int]:
    """How often each symbol is needed; what nobody asks for counts zero."""
    uses = [0] * len(tape.symbols)
    for value in values:
        if isinstance(value, Symbol):
            uses[value.number] += 1
    for symbol in reversed(tape.symbols.values()):
        for argument in symbol.arguments if uses[symbol.number] else ():
            if isinstance(argument, Symbol):
                uses[argument.number] += 1
    return uses


def _written_operation(name: str, arguments: list[str]) -> str:
    if not arguments:
        return name
    if name == "neg":
        return f"(-{arguments[0]})"
    if name in ("+", "-", "*", "/"):
        return f"({arguments[0]} {name} {arguments[1]})"
    return f"{name}({', '.join(arguments)})"


class Tape:
    """What was done to the symbols, each operation once, in the order of its first use."""

    def __init__(self) -> None:
        self.symbols: dict[tuple[Any, ...], Symbol] = {}

    def record(self, name: str, *arguments: Any) -> "Symbol":
        arguments = tuple(a if isinstance(a, Symbol) else float(a) for a in arguments)
        key = (name, *(("symbol", a.number) if isinstance(a, Symbol) else a for a in arguments))
        if key not in self.symbols:
            self.symbols[key] = Symbol(self, len(self.symbols), name, arguments)
        return self.symbols[key]


def _operator(combined: Callable[[Tape, Any, Any], Any], swapped: bool = False) -> Callable[..., Any]:
    def method(self: "Symbol", other: Any) -> Any:
        if isinstance(other, np.ndarray):
            return NotImplemented  # NumPy goes through the elements
        return combined(self.tape, other, self) if swapped else combined(self.tape, self, other)

    return method


def _sum(tape: Tape, a: Any, b: Any) -> Any:
    if _is(a, 0) or _is(b, 0):
        return b if _is(a, 0) else a
    if isinstance(b, Symbol) and b.name == "neg":
        return _difference(tape, a, b.arguments[0])
    return tape.record("+", *_ordered(a, b))


def _difference(tape: Tape, a: Any, b: Any) -> Any:
    if _is(a, 0) or _is(b, 0):
        return -b if _is(a, 0) else a
    if isinstance(b, Symbol) and b.name == "neg":
        return _sum(tape, a, b.arguments[0])
    return tape.record("-", a, b)


def _product(tape: Tape, a: Any, b: Any) -> Any:
    for number, other in ((a, b), (b, a)):
        if _is(number, 0):
            return 0.0
        if _is(number, 1) or _is(number, -1):
            return other if _is(number, 1) else -other
    return tape.record("*", *_ordered(a, b))


def _quotient(tape: Tape, a: Any, b: Any) -> Any:
    if _is(a, 0):
        return 0.0
    return a if _is(b, 1) else tape.record("/", a, b)


def _power(tape: Tape, base: Any, exponent: Any) -> Any:
    """Small whole and half powers as products and a root: faster than pow, and no less accurate."""
    if isinstance(exponent, Symbol) or not float(2 * exponent).is_integer() or abs(exponent) > 8:
        return tape.record("pow", base, exponent)
    if exponent < 0:
        return _quotient(tape, 1.0, _power(tape, base, -exponent))
    root = tape.record("sqrt", base) if exponent % 1 else 1.0
    return functools.reduce(lambda product, _: product * base, range(int(exponent)), root)


def _is(value: Any, number: float) -> bool:
    return not isinstance(value, Symbol) and bool(value == number)


def _ordered(a: Any, b: Any) -> tuple[Any, Any]:
    """a + b is b + a, to the last bit: one order for both."""
    first, second = (x.number if isinstance(x, Symbol) else -1 for x in (a, b))
    return (a, b) if first <= second else (b, a)


def _refuse(*_: Any) -> Any:
    raise Untraceable("depends on the value of the state")


class Symbol:
    """A number not known yet."""

    __slots__ = ("arguments", "name", "number", "tape")

    def __init__(self, tape: Tape, number: int, name: str, arguments: tuple[Any, ...]) -> None:
        self.tape, self.number, self.name, self.arguments = tape, number, name, arguments

    __add__, __radd__ = _operator(_sum), _operator(_sum, swapped=True)
    __sub__, __rsub__ = _operator(_difference), _operator(_difference, swapped=True)
    __mul__, __rmul__ = _operator(_product), _operator(_product, swapped=True)
    __truediv__, __rtruediv__ = _operator(_quotient), _operator(_quotient, swapped=True)
    __pow__, __rpow__ = _operator(_power), _operator(_power, swapped=True)

    def __neg__(self) -> Any:
        return self.arguments[0] if self.name == "neg" else self.tape.record("neg", self)

    def __pos__(self) -> Any:
        return self

    def __abs__(self) -> Any:
        return self.tape.record("fabs", self)

    def __getattr__(self, name: str) -> Callable[..., Any]:
        """NumPy's functions ask an object for a method of their name."""
        if name not in FUNCTIONS:
            raise AttributeError(name)
        return functools.partial(self.tape.record, FUNCTIONS[name], self)

    __float__ = __int__ = __bool__ = __index__ = __round__ = __floor__ = __ceil__ = _refuse
    __lt__ = __le__ = __gt__ = __ge__ = __mod__ = __rmod__ = __floordiv__ = __rfloordiv__ = _refuse
    __eq__ = __ne__ = _refuse
    __hash__ = object.__hash__


_NAMES = """sin cos tan asin acos atan atan2 sinh cosh tanh asinh acosh atanh
exp expm1 log log1p log2 log10 sqrt cbrt hypot fabs erf erfc"""
FUNCTIONS = {name: name for name in _NAMES.split()}
FUNCTIONS |= {"arc" + name[1:]: name for name in FUNCTIONS if name[0] == "a"} | {"absolute": "fabs"}


class _Mathematics:
    """The module math for symbols; numbers go to the real one."""

    def __getattr__(self, name: str) -> Any:
        return _symbolic(getattr(math, name))


def _symbolic(function: Any) -> Any:
    name = getattr(function, "__name__", "")
    if name not in FUNCTIONS and name != "pow":
        return function

    def either(*arguments: Any) -> Any:
        symbol = next((a for a in arguments if isinstance(a, Symbol)), None)
        if symbol is None:
            return function(*arguments)
        return arguments[0] ** arguments[1] if name == "pow" else symbol.tape.record(name, *arguments)

    return either


def _translated(value: Any, known: dict[int, Any]) -> Any:
    """`value` with math replaced by its symbolic kin, in all the functions that it calls."""
    if value is math:
        return _Mathematics()
    if isinstance(value, types.BuiltinFunctionType):
        return _symbolic(value) if value.__module__ == "math" else value
    if isinstance(value, functools.partial):
        return functools.partial(_translated(value.func, known), *value.args, **value.keywords)
    if isinstance(value, types.MethodType):
        return types.MethodType(_translated(value.__func__, known), value.__self__)
    if isinstance(value, types.FunctionType) and not (value.__module__ or "").startswith("numpy"):
        return known[id(value)] if id(value) in known else _translated_function(value, known)
    return value


def _translated_function(function: types.FunctionType, known: dict[int, Any]) -> types.FunctionType:
    names = dict(function.__globals__)
    cells = tuple(types.CellType() for _ in function.__closure__ or ())
    twin = types.FunctionType(function.__code__, names, function.__name__, function.__defaults__, cells)
    twin.__kwdefaults__ = function.__kwdefaults__
    known[id(function)] = twin  # before its names are looked at: it may call itself
    for name in _global_names(function.__code__) & names.keys():
        names[name] = _translated(names[name], known)
    for cell, original in zip(cells, function.__closure__ or (), strict=True):
        cell.cell_contents = _translated(original.cell_contents, known)
    return twin


def _global_names(code: types.CodeType) -> set[str]:
    inner = (_global_names(c) for c in code.co_consts if isinstance(c, types.CodeType))
    return set(code.co_names).union(*inner)
