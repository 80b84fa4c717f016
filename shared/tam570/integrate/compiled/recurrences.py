"""Turns a recorded right-hand side into recurrences for the Taylor coefficients of every intermediate value.

Each function is reduced to sums, products, quotients, roots, powers and differential equations y' = w a' or w y' = a',
such as sin' = cos a' and (1 + a^2) atan' = a'. Jorba and Zou, A software package for the numerical integration of ODEs
by means of high-order Taylor methods, Experimental Mathematics 14 (2005).
"""

import math
from collections.abc import Callable
from dataclasses import dataclass

from tam570.integrate.trace import Graph, Symbol, Value


class NotAnalytic(TypeError):
    """The right-hand side uses a function that is not analytic."""


@dataclass(frozen=True)
class Recurrence:
    """A series and the indices `of` of the series it is computed from; index -1 - k is constant k.

    rule  : "time", "state", "+", "-", "neg", "scale", "shift", "*", "square", "/", "sqrt", "pow", or a differential
            equation: "y'=wa'" of (w, a), "wy'=a'" of (w, a), "wy'=ab'-ba'" of (w, b, a) for atan2
    value : the function that computes the coefficient of order 0 from `arguments`; "" if the rule does
    """

    rule: str
    of: tuple[int, ...]
    value: str = ""
    arguments: tuple[int, ...] = ()


@dataclass(frozen=True)
class Recurrences:
    """All series, each after those that it needs at the same order; `rates` are indices like `Recurrence.of`."""

    series: tuple[Recurrence, ...]
    rates: tuple[int, ...]
    constants: int


def recurrences(graph: Graph) -> tuple[Recurrences, tuple[float, ...]]:
    """Return the recurrences of a graph, and their constants; raise NotAnalytic."""
    making = _Making()
    places: dict[int, int] = {}

    def index_of(value: Value) -> int:
        return places[value.number] if isinstance(value, Symbol) else making.constant(value)

    needed = {rate.number for rate in graph.rates if isinstance(rate, Symbol)}
    for symbol in reversed(graph.operations):
        if symbol.number in needed:
            needed |= {a.number for a in symbol.arguments if isinstance(a, Symbol)}
    for symbol in graph.operations:
        if symbol.number in needed or symbol.name[0] == "s" and not symbol.arguments:
            places[symbol.number] = making.function(symbol.name, tuple(map(index_of, symbol.arguments)))
    rates = tuple(map(index_of, graph.rates))
    return Recurrences(tuple(making.listed), rates, len(making.constants)), tuple(making.constants)


class _Making:
    """Builds the list of series, without duplicates."""

    def __init__(self) -> None:
        self.series: dict[Recurrence, int] = {}
        self.listed: list[Recurrence] = []  # the same in order of index
        self.constants: dict[float, int] = {}

    def constant(self, value: float) -> int:
        return -1 - self.constants.setdefault(value, len(self.constants))

    def constant_at(self, index: int) -> float:
        return list(self.constants)[-1 - index]

    def add(self, rule: str, *of: int, value: str = "", arguments: tuple[int, ...] = ()) -> int:
        recurrence = Recurrence(rule, of, value, arguments)
        index = self.series.setdefault(recurrence, len(self.series))
        if index == len(self.listed):
            self.listed.append(recurrence)
        return index

    def function(self, name: str, of: tuple[int, ...]) -> int:
        if not of:
            return self.add("time") if name == "t" else self.add("state", int(name[1:]))
        if name in _ARITHMETIC:
            return _ARITHMETIC[name](self, *of)
        if name in _DERIVATIVES:
            return _DERIVATIVES[name](self, name, *of)
        raise NotAnalytic(f"{name} has no derivatives of all orders")

    # Arithmetic; either operand may be a constant

    def sum(self, a: int, b: int) -> int:
        if a < 0 or b < 0:  # not both: a trace adds up constants
            return self.add("shift", max(a, b), min(a, b))
        return self.add("+", a, b)

    def difference(self, a: int, b: int) -> int:
        if b < 0:
            return self.add("shift", a, self.constant(-self.constant_at(b)))
        return self.sum(a, self.add("neg", b)) if a < 0 else self.add("-", a, b)

    def product(self, a: int, b: int) -> int:
        if a < 0 and b < 0:
            return self.constant(self.constant_at(a) * self.constant_at(b))
        if a < 0 or b < 0:
            return self.add("scale", max(a, b), min(a, b))
        return self.add("square", a) if a == b else self.add("*", a, b)

    def quotient(self, a: int, b: int) -> int:
        """Return a / b. (k a) / b becomes k (a / b), so that bodies that attract each other share the quotient."""
        if b >= 0:
            numerator = self.listed[a] if a >= 0 else None
            if numerator and numerator.rule == "scale":
                return self.product(self.quotient(numerator.of[0], b), numerator.of[1])
            return self.add("/", a, b)
        if not self.constant_at(b):
            raise NotAnalytic("a division by zero")
        return self.add("scale", a, self.constant(1 / self.constant_at(b)))

    def power(self, a: int, b: int) -> int:
        if b < 0 <= a:
            return self.add("pow", a, b, value="pow", arguments=(a, b))
        if a < 0 and self.constant_at(a) <= 0:
            raise NotAnalytic("a power of a negative number")
        logarithm = self.logarithm("log", a) if a >= 0 else self.constant(math.log(self.constant_at(a)))
        return self.following("pow", (a, b), self.product(b, logarithm))

    def following(self, name: str, arguments: tuple[int, ...], exponent: int) -> int:
        """Return exp(exponent), by y' = y exponent'; its coefficient of order 0 is name(arguments)."""
        index = len(self.series)
        return self.add("y'=wa'", index, exponent, value=name, arguments=arguments)

    def root(self, name: str, a: int) -> int:
        return self.add("sqrt", a, value="sqrt", arguments=(a,))

    def exponential(self, name: str, a: int) -> int:
        plain = next((i for r, i in self.series.items() if r.value == "exp" and r.arguments == (a,)), None)
        plain = self.following("exp", (a,), a) if plain is None else plain
        return plain if name == "exp" else self.add("y'=wa'", plain, a, value="expm1", arguments=(a,))

    def turning(self, name: str, a: int) -> int:
        """Return sin or cos, or sinh or cosh, as a pair: each is the derivative of the other, up to a sign."""
        hyperbolic = "h" if name.endswith("h") else ""
        first, second = f"sin{hyperbolic}", f"cos{hyperbolic}"
        index = next((i for r, i in self.series.items() if r.value == first and r.arguments == (a,)), None)
        if index is None:
            index = len(self.series)
            self.add("y'=wa'", index + 1, a, value=first, arguments=(a,))
            self.add("y'=wa'" if hyperbolic else "y'=-wa'", index, a, value=second, arguments=(a,))
        return index + (name == second)

    def tangent(self, name: str, a: int) -> int:
        """Return tan or tanh, by y' = a' +- y^2 a'. The series y^2 follows y, since order n needs it up to n - 1."""
        rule = "y'=a'+y^2a'" if name == "tan" else "y'=a'-y^2a'"
        index = len(self.series)
        self.add(rule, index + 1, a, value=name, arguments=(a,))
        self.add("square", index)
        return index

    def inverse(self, name: str, a: int) -> int:
        """Return an inverse trigonometric or hyperbolic function, by w y' = a', or w y' = -a' for acos."""
        sign = {"atan": 1, "asinh": 1, "acosh": -1, "atanh": -1, "asin": -1, "acos": -1}[name]
        square = self.add("square", a)
        w = self.add("shift", square if sign > 0 else self.add("neg", square), self.constant(1.0))
        if name == "acosh":
            w = self.add("neg", w)
        if name not in ("atan", "atanh"):
            w = self.root("sqrt", w)
        return self.add("wy'=-a'" if name == "acos" else "wy'=a'", w, a, value=name, arguments=(a,))

    def logarithm(self, name: str, a: int) -> int:
        w = self.add("shift", a, self.constant(1.0)) if name == "log1p" else a
        if name in ("log2", "log10"):
            w = self.add("scale", a, self.constant(0.6931471805599453 if name == "log2" else 2.302585092994046))
        return self.add("wy'=a'", w, a, value=name, arguments=(a,))

    def hypotenuse(self, name: str, a: int, b: int) -> int:
        squares = self.sum(self.product(a, a), self.product(b, b))
        return self.add("sqrt", squares, value="hypot", arguments=(a, b))

    def error_function(self, name: str, a: int) -> int:
        bell = self.exponential("exp", self.add("neg", self.add("square", a)))
        slope = 1.1283791670955126 if name == "erf" else -1.1283791670955126  # 2 / sqrt(pi)
        w = self.add("scale", bell, self.constant(slope))
        return self.add("y'=wa'", w, a, value=name, arguments=(a,))

    def angle(self, name: str, b: int, a: int) -> int:
        """Return atan2(b, a), by (a^2 + b^2) y' = a b' - b a'."""
        if a < 0 or b < 0:
            raise NotAnalytic("atan2 of a number")
        w = self.sum(self.product(a, a), self.product(b, b))
        return self.add("wy'=ab'-ba'", w, b, a, value="atan2", arguments=(b, a))


_ARITHMETIC: dict[str, Callable[..., int]] = {
    "+": _Making.sum,
    "-": _Making.difference,
    "*": _Making.product,
    "/": _Making.quotient,
    "pow": _Making.power,
    "neg": lambda making, a: making.add("neg", a),
}
_DERIVATIVES: dict[str, Callable[..., int]] = (
    dict.fromkeys(("sin", "cos", "sinh", "cosh"), _Making.turning)
    | dict.fromkeys(("tan", "tanh"), _Making.tangent)
    | dict.fromkeys(("exp", "expm1"), _Making.exponential)
    | dict.fromkeys(("log", "log1p", "log2", "log10"), _Making.logarithm)
    | dict.fromkeys(("asin", "acos", "atan", "asinh", "acosh", "atanh"), _Making.inverse)
    | dict.fromkeys(("erf", "erfc"), _Making.error_function)
    | {"sqrt": _Making.root, "hypot": _Making.hypotenuse, "atan2": _Making.angle}
)
_DERIVATIVES |= {
    "cbrt": lambda making, name, a: making.add("pow", a, making.constant(1 / 3), value=name, arguments=(a,))
}
