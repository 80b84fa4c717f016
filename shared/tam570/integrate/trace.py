"""Traces a right-hand side: calls it once with symbols instead of numbers, and records its operations as a graph.

Parameters are numbers, so expressions that depend only on them are evaluated at once. Each operation is recorded once,
in the order of first use, and simplified: a product with zero is zero, a sum with zero is the other term. A function
that needs the value of a symbol (in a comparison, a loop until convergence, a compiled routine) cannot be traced.
"""

import contextlib
import dis
import functools
import math
import operator
import types
from collections.abc import Callable
from dataclasses import dataclass
from numbers import Complex, Real

import numpy as np

from tam570.integrate.cache_key import global_names
from tam570.values import Function, Numbers, Parameters


class Untraceable(TypeError):
    """Raised if a function needs the value of a symbol."""


class Tape:
    """Records the operations on symbols, each once, in the order of first use."""

    def __init__(self) -> None:
        self.symbols: dict[tuple[Numbers, ...], Symbol] = {}

    def record(self, name: str, *arguments: Numbers) -> "Symbol":
        arguments = tuple([a if isinstance(a, Symbol) else float(a) for a in arguments])
        key = (name, *[("symbol", a.number) if isinstance(a, Symbol) else a for a in arguments])
        if key not in self.symbols:
            self.symbols[key] = Symbol(self, len(self.symbols), name, arguments)
        return self.symbols[key]

    def combine(self, name: str, *operands: Numbers) -> Numbers:
        """Return the result of a Python operator on symbols and numbers, simplified."""
        return SIMPLIFIED[name](self, *operands)

    def method(self, name: str) -> Function:
        """Return a function of symbols, by the name of the method that NumPy calls for it on objects."""
        if name not in FUNCTIONS:
            raise AttributeError(name)
        return functools.partial(self.record, FUNCTIONS[name])

    def sign(self, x: "Symbol") -> float:
        """Return the sign of x, by which the function decides; raise Untraceable if it is unknown, as here."""
        raise Untraceable("it depends on the value of the state")

    def rounded(self, x: "Symbol", half: float = 0.0) -> float:
        """Return x rounded down to an integer, or to the nearest one with half = 0.5."""
        return self.sign(x)


def _called(function: Function, *arguments: Numbers) -> Numbers:
    """Return the result of a function of the module math on symbols, or on numbers only."""
    symbol = next((a for a in arguments if isinstance(a, Symbol)), None)
    if symbol is None:
        return function(*arguments)
    name, (first, *rest) = function.__name__, arguments
    if name == "log" and rest:
        return _called(function, first) / _called(function, *rest)
    if name == "hypot" and len(rest) != 1:
        return _called(function, _called(function, first, rest[0]), *rest[1:]) if rest else abs(symbol)
    return first ** rest[0] if name == "pow" else symbol.tape.record(name, *arguments)


def _operator(name: str, swapped: bool = False) -> Numbers:
    def method(self: "Symbol", other: Numbers) -> Numbers:
        if not isinstance(other, (Symbol, float, Complex)):  # frequent types first, and no union built per call
            return NotImplemented  # for an array, NumPy then applies the operator to its elements
        return self.tape.combine(name, *((other, self) if swapped else (self, other)))

    return method


def _comparison(compare: Callable[[Numbers, Numbers], bool]) -> Numbers:
    def method(self: "Symbol", other: Numbers) -> Numbers:
        if not isinstance(other, Symbol | Real):
            return NotImplemented
        return compare(self.tape.sign(self.tape.combine("-", self, other)), 0.0)

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
    """Return a power; small integers and halves become products and a root, faster than pow and as accurate."""
    if isinstance(exponent, Symbol) or not float(2 * exponent).is_integer() or abs(exponent) > 8:
        return tape.record("pow", base, exponent)
    if exponent < 0:
        return _quotient(tape, 1.0, _power(tape, base, -exponent))
    root = tape.record("sqrt", base) if exponent % 1 else 1.0
    return functools.reduce(lambda product, _: product * base, range(int(exponent)), root)


def _is(value: Numbers, number: float) -> bool:
    return not isinstance(value, Symbol) and bool(value == number)


def _ordered(a: Numbers, b: Numbers) -> tuple[Numbers, Numbers]:
    """Return the operands in a fixed order, since a + b equals b + a to the last bit."""
    first = a.number if isinstance(a, Symbol) else -1
    second = b.number if isinstance(b, Symbol) else -1
    return (a, b) if first <= second else (b, a)


SIMPLIFIED: dict[str, Function] = {
    **{"+": _sum, "-": _difference, "*": _product, "/": _quotient, "pow": _power},
    "neg": lambda tape, a: a.arguments[0] if a.name == "neg" else tape.record("neg", a),
    "fabs": lambda tape, a: tape.record("fabs", a),
}


def _refuse(*_: Numbers) -> Numbers:
    raise Untraceable("it depends on the value of the state")


class Symbol:
    """An unknown number. Its tape records the operations on it, and answers or refuses questions about its value.

    name, arguments : of the operation whose result it is; number : its index on the tape
    """

    __slots__ = ("arguments", "name", "number", "tape")

    def __init__(self, tape: Tape, number: int, name: str, arguments: tuple[Numbers, ...]) -> None:
        self.tape, self.number, self.name, self.arguments = tape, number, name, arguments

    __add__, __radd__ = _operator("+"), _operator("+", swapped=True)
    __sub__, __rsub__ = _operator("-"), _operator("-", swapped=True)
    __mul__, __rmul__ = _operator("*"), _operator("*", swapped=True)
    __truediv__, __rtruediv__ = _operator("/"), _operator("/", swapped=True)
    __pow__, __rpow__ = _operator("pow"), _operator("pow", swapped=True)
    __lt__, __le__ = _comparison(operator.lt), _comparison(operator.le)
    __gt__, __ge__ = _comparison(operator.gt), _comparison(operator.ge)
    __eq__, __ne__ = _comparison(operator.eq), _comparison(operator.ne)
    __float__ = __index__ = __complex__ = __hash__ = __str__ = __repr__ = __format__ = __reduce_ex__ = _refuse

    def __neg__(self) -> Numbers:
        return self.tape.combine("neg", self)

    def __pos__(self) -> Numbers:
        return self

    def __abs__(self) -> Numbers:
        return self.tape.combine("fabs", self)

    def __bool__(self) -> bool:
        return self.tape.sign(self) != 0.0

    def __floor__(self) -> int:
        return int(self.tape.rounded(self))

    def __ceil__(self) -> int:
        return -int(self.tape.rounded(-self))

    def __trunc__(self) -> int:
        return self.__floor__() if self.tape.sign(self) >= 0 else self.__ceil__()

    __int__ = __trunc__

    def __round__(self, digits: Numbers = None) -> Numbers:
        scale = 10.0 ** (digits or 0)
        value = self.tape.rounded(self * scale, 0.5)
        return int(value) if digits is None else value / scale

    def __floordiv__(self, period: Numbers) -> Numbers:
        return self.tape.rounded(self / period)

    def __mod__(self, period: Numbers) -> Numbers:
        return self - self // period * period

    def __rfloordiv__(self, other: Numbers) -> Numbers:
        return self.tape.rounded(other / self)

    def __rmod__(self, other: Numbers) -> Numbers:
        return other - self.__rfloordiv__(other) * self

    def __divmod__(self, period: Numbers) -> Numbers:
        return self // period, self % period

    def __getattr__(self, name: str) -> Function:
        """Return the method that the NumPy function `name` calls on objects, or the real or imaginary part."""
        method = functools.partial(self.tape.method(name), self)
        return method() if name in ("real", "imag") else method


_NAMES = """sin cos tan asin acos atan atan2 sinh cosh tanh asinh acosh atanh
exp expm1 log log1p log2 log10 sqrt cbrt hypot fabs erf erfc"""
FUNCTIONS = {name: name for name in _NAMES.split()}
FUNCTIONS |= {"arc" + name[1:]: name for name in FUNCTIONS if name[0] == "a"} | {"absolute": "fabs"}
NUMPY_NAMES = {plain: name for name, plain in FUNCTIONS.items() if name.startswith("arc")} | {"pow": "power"}

# Edges of the domain, beyond which a function raises an error, returns NaN, or jumps.
EDGES: dict[str, tuple[float, ...]] = dict.fromkeys(("sqrt", "log", "log2", "log10", "pow"), (0.0,))
EDGES |= dict.fromkeys(("asin", "acos", "atanh", "arcsin", "arccos", "arctanh"), (-1.0, 1.0))

OPERATORS: dict[str, Function] = {
    **{"+": operator.add, "-": operator.sub, "*": operator.mul, "neg": operator.neg},
    **{"/": np.true_divide, "pow": np.power},
}

Value = Symbol | float


@functools.cache
def on_arrays(name: str) -> Function:
    """Return the operation `name` as a function of arrays."""
    function = OPERATORS.get(name) or getattr(np, NUMPY_NAMES.get(name, name), None)
    return np.vectorize(getattr(math, name), otypes=[float]) if function is None else function


# Exceptions that Python, NumPy and careful functions raise for an argument that is not a number.
ANSWERS = (TypeError, ValueError, AttributeError, ArithmeticError, LookupError, AssertionError, RuntimeError)


@dataclass(frozen=True, eq=False)
class Graph:
    """The operations of a right-hand side on time and state, each after those whose results it uses.

    operations : symbols; the first are "t", "s0", "s1", ..., without arguments; `number` is the index in this tuple
    rates      : a symbol or a number for each component
    """

    operations: tuple[Symbol, ...]
    rates: tuple[Value, ...]


def traced(rates: Function, size: int, stand_ins: Parameters | None = None) -> Graph:
    """Return the graph of rates(t, y) with `size` components; raise Untraceable, with the reason, if there is none.

    stand_ins : replacements of built-in functions, such as `float`, by name
    """
    tape = Tape()
    time, state = tape.record("t"), [tape.record(f"s{i}") for i in range(size)]
    try:
        values = substituted(rates, _substitute, {**STAND_INS, **(stand_ins or {})})(time, np.array(state))
        listed = tuple(v if isinstance(v, Symbol) else float(v) for v in values)
    except Exception as answer:
        raise _refusal(answer) from answer
    return Graph(tuple(tape.symbols.values()), listed)


def _refusal(answer: Exception) -> Exception:
    """Return Untraceable with the reason if the function does not accept symbols, else the error of the function."""
    cause: BaseException | None = answer
    while cause is not None:
        if isinstance(cause, Untraceable):  # the function may have raised another error from it
            return Untraceable(str(cause))
        cause = cause.__cause__ or cause.__context__
    return Untraceable(refusal_of(answer)) if isinstance(answer, ANSWERS) else answer


def refusal_of(answer: Exception) -> str:
    """Return what a function does that does not accept symbols."""
    message = f"it accepts only numbers; for a symbol it raises {type(answer).__name__}: {answer}"
    return str(answer) if isinstance(answer, Untraceable) else message


class Module:
    """Stands in for a module; substitute : returns the replacement of an attribute."""

    def __init__(self, module: types.ModuleType, substitute: Callable[[Numbers], Numbers]) -> None:
        self.module, self.substitute = module, substitute

    def __getattr__(self, name: str) -> Numbers:
        value = self.substitute(getattr(self.module, name))
        setattr(self, name, value)  # cached
        return value


def _checked_isinstance(value: Numbers, kinds: Numbers) -> bool:
    """Stand in for isinstance; raise Untraceable for a symbol, whose type is unknown."""
    if isinstance(value, Symbol):
        raise Untraceable("it depends on the type of the state's components")
    return isinstance(value, kinds)


STAND_INS = {"isinstance": _checked_isinstance}


def _substitute(value: Numbers) -> Numbers:
    """Return the replacement of math or one of its functions, else the value itself."""
    if value is math:
        return Module(math, _substitute)
    is_of_math = isinstance(value, types.BuiltinFunctionType) and value.__module__ == "math"
    return functools.partial(_called, value) if is_of_math and value.__name__ in {*FUNCTIONS, "pow"} else value


def substituted(
    value: Numbers,
    substitute: Callable[[Numbers], Numbers],
    stand_ins: Parameters,
    twins: dict[int, types.FunctionType] | None = None,
) -> Numbers:
    """Return a copy of a function in which it and the functions that it calls refer to replacements of their values.

    substitute : returns the replacement of a value, or the value itself
    stand_ins  : replacements of built-in functions, by name
    twins      : copies of functions so far, by the id of the original, as a function may call itself
    """
    twins = {} if twins is None else twins
    if (other := substitute(value)) is not value:
        return other
    if isinstance(value, functools.partial):
        return functools.partial(substituted(value.func, substitute, stand_ins, twins), *value.args, **value.keywords)
    if isinstance(value, types.MethodType):
        return types.MethodType(substituted(value.__func__, substitute, stand_ins, twins), value.__self__)
    if not isinstance(value, types.FunctionType) or (value.__module__ or "").startswith("numpy"):
        return value
    if id(value) in twins:
        return twins[id(value)]
    names = {**stand_ins, **value.__globals__}
    cells = tuple(types.CellType() for _ in value.__closure__ or ())
    twin = types.FunctionType(value.__code__, names, value.__name__, None, cells)
    sets_items = dis.opmap["STORE_SUBSCR"] in value.__code__.co_code[::2]
    twins[id(value)] = twin  # first, because the function may refer to itself

    def stand_in(used: Numbers) -> Numbers:
        """Return the replacement; copy lists and arrays, so that the function does not modify the originals."""
        if type(used) is np.ndarray and used.dtype == float and sets_items:
            return used.astype(object)
        if type(used) in (list, tuple, set):
            return type(used)(map(stand_in, used))
        if type(used) is dict:
            return {key: stand_in(item) for key, item in used.items()}
        return substituted(used, substitute, stand_ins, twins)

    for name in global_names(value.__code__) & value.__globals__.keys():
        names[name] = stand_in(names[name])
    for cell, original in zip(cells, value.__closure__ or (), strict=True):
        with contextlib.suppress(ValueError):  # the cell is still empty
            cell.cell_contents = stand_in(original.cell_contents)
    twin.__defaults__, twin.__kwdefaults__ = stand_in(value.__defaults__), stand_in(value.__kwdefaults__)
    return twin
