"""Traced right-hand sides as source: assignments from t, s0, s1, ... and c0, c1, ..., and an expression per rate."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from functools import cached_property

from tam570.integrate.trace import Graph, Symbol, Value

UNIT_ROUNDOFF = 2.0**-53
SATURATING = {"exp", "expm1", "tanh", "erf", "erfc", "sinh", "cosh"}  # change mainly at arguments near zero
BENT = {"fabs", "cbrt"}  # have a kink or infinite slope at zero
LONGEST = 200  # characters of an expression; Python limits the depth of nested parentheses


@dataclass(frozen=True)
class Bounds:
    """A running error bound of a right-hand side, as source."""

    values: tuple[str, ...]  # lines that set z0, z1, ... to the results of the operations
    lines: tuple[str, ...]  # lines that set b0, b1, ... to bounds of their round-off, from b_s0, b_s1, ... and b_t
    rates: tuple[str, ...]  # the bounds of the rates
    exponents: tuple[str, ...]  # arguments of SATURATING operations that depend on the state, in terms of `values`
    bends: tuple[str, ...]  # the same of BENT operations


@dataclass(frozen=True)
class Formulas:
    """A right-hand side as source: `lines` compute variables from t, s0, s1, ... and c0, c1, ... for the `rates`."""

    lines: tuple[str, ...]
    rates: tuple[str, ...]
    constants: int = 0
    reads: frozenset[int] = frozenset()  # components of the state that occur
    timed: bool = False  # whether t occurs
    saturates: bool = False  # whether SATURATING operations occur
    is_bent: bool = False  # whether BENT operations occur
    # what the source was written from; not compared, since equal formulas have equal bounds
    graph: Graph = field(default=Graph((), ()), compare=False, repr=False)
    constant_names: dict[float, str] = field(default_factory=dict, compare=False, repr=False)  # of the constants

    @property
    def size(self) -> int:
        return len(self.rates)

    @property
    def moving(self) -> list[int]:
        """The components that change; a rate that is constantly zero needs no stages."""
        return [i for i, rate in enumerate(self.rates) if rate != "0.0"]

    @cached_property
    def bounds(self) -> Bounds:
        """The running error bound, written on demand because most runs do not need it."""
        return _bounds(self.graph, self.constant_names)

    @property
    def exponents(self) -> tuple[str, ...]:
        """Arguments of SATURATING operations that depend on the state, in terms of `bounds.values`."""
        return self.bounds.exponents if self.saturates else ()

    @property
    def bends(self) -> tuple[str, ...]:
        """Arguments of BENT operations that depend on the state, in terms of `bounds.values`."""
        return self.bounds.bends if self.is_bent else ()


def written(graph: Graph) -> tuple[Formulas, tuple[float, ...]]:
    """Return the formulas of a right-hand side and the values of its constants."""
    constants: dict[float, str] = {}
    return _written(graph, constants), tuple(constants)


def halves(graph: Graph) -> tuple[Formulas, Formulas, tuple[float, ...]]:
    """Return the formulas for the first and second half of the state, and the values of their common constants."""
    constants: dict[float, str] = {}
    _written(graph, constants)
    middle = len(graph.rates) // 2
    parts = (Graph(graph.operations, part) for part in (graph.rates[:middle], graph.rates[middle:]))
    first, second = (_written(part, constants) for part in parts)
    return first, second, tuple(constants)


def call_of(size: int, timed: bool = True) -> Formulas:
    """Return formulas that call `rhs` for `size` components; timed : whether it depends on t."""
    return by_call(Formulas((), tuple(names("p", size)), 0, frozenset(range(size)), timed))


def by_call(formulas: Formulas) -> Formulas:
    """Return formulas that call `rhs` but have the same zero rates and inputs: shorter, so faster to compile."""
    rates = tuple("0.0" if rate == "0.0" else f"p{i}" for i, rate in enumerate(formulas.rates))
    state = tuple_of(f"s{i}" if i in formulas.reads else "0.0" for i in range(formulas.size))
    line = f"{tuple_of(names('p', formulas.size))} = rhs({'t' if formulas.timed else '0.0'}, {state}, c)"
    return Formulas((line,), rates, 0, formulas.reads, formulas.timed)


def names(letter: str, size: int) -> list[str]:
    """Return the names s0, s1, ... for letter "s"."""
    return [f"{letter}{i}" for i in range(size)]


def tuple_of(items: Iterable[str]) -> str:
    """Return source of a tuple, also of one item or none; it can be the target of an assignment."""
    return "(" + "".join(f"{item}, " for item in items) + ")"


def unpacked(formulas: Formulas, **letters: str) -> list[str]:
    """Return lines that unpack the tuple `name` into y0, y1, ... for each `name="y"`, and c into the constants."""
    lines = [f"{tuple_of(names(letter, formulas.size))} = {name}" for name, letter in letters.items()]
    constants = [f"{tuple_of(names('c', formulas.constants))} = c"] if formulas.constants else []
    return lines + constants


def _texts(
    operations: Sequence[Symbol], uses: list[int], constants: dict[float, str], name: str, longest: float
) -> tuple[list[str], dict[int, str]]:
    """Return lines that set v0, v1, ... for name = "v", and the text of each operation.

    An operation that is used once gets no variable, unless it has more than `longest` characters.
    """
    texts: dict[int, str] = {}
    lines: list[str] = []
    for symbol in operations:
        if not uses[symbol.number]:
            continue
        arguments = [_text(a, texts, constants) for a in symbol.arguments]
        expression = texts[symbol.number] = _expression(symbol.name, arguments)
        if symbol.arguments and (uses[symbol.number] > 1 or len(expression) > longest):
            texts[symbol.number] = f"{name}{len(lines)}"
            lines.append(f"{name}{len(lines)} = {expression}")
    return lines, texts


def _text(value: Value, texts: dict[int, str], constants: dict[float, str]) -> str:
    if isinstance(value, Symbol):
        return texts[value.number]
    return constants.setdefault(value, f"c{len(constants)}") if value else "0.0"


def _written(graph: Graph, constants: dict[float, str]) -> Formulas:
    uses = uses_of(graph.operations, graph.rates)
    lines, texts = _texts(graph.operations, uses, constants, "v", LONGEST)
    expressions = tuple(_text(rate, texts, constants) for rate in graph.rates)
    used = [symbol for symbol in graph.operations if uses[symbol.number]]
    read = {symbol.name for symbol in used if not symbol.arguments}
    reads = frozenset(int(name[1:]) for name in read if name != "t")
    saturates, is_bent = (any(symbol.name in names for symbol in used) for names in (SATURATING, BENT))
    return Formulas(tuple(lines), expressions, len(constants), reads, "t" in read, saturates, is_bent, graph, constants)


def _bounds(graph: Graph, constants: dict[float, str]) -> Bounds:
    """Return source for the error of each operation: that propagated from its arguments plus its round-off."""
    uses = uses_of(graph.operations, graph.rates)
    values, texts = _texts(graph.operations, uses, constants, "z", 0)
    bounds: list[str] = []

    def bound(value: Value) -> str:
        """Return the name of a bound: b3 for z3, b_s1 for s1 of the state; empty for a number."""
        text = texts[value.number] if isinstance(value, Symbol) else ""
        return f"b{text[1:]}" if text[:1] == "z" else text and f"b_{text}"

    for symbol in graph.operations:
        if uses[symbol.number] and symbol.arguments:
            arguments = [(_text(a, texts, constants), bound(a)) for a in symbol.arguments]
            bounds.append(f"{bound(symbol)} = {_bound_of(symbol.name, texts[symbol.number], arguments)}")

    def arguments_of(functions: set[str]) -> tuple[str, ...]:
        firsts = [s.arguments[0] for s in graph.operations if uses[s.number] and s.name in functions]
        return tuple(dict.fromkeys(texts[a.number] for a in firsts if isinstance(a, Symbol) and _moves_with_state(a)))

    rates = tuple(bound(rate) or "0.0" for rate in graph.rates)
    return Bounds(tuple(values), tuple(bounds), rates, arguments_of(SATURATING), arguments_of(BENT))


def _moves_with_state(symbol: Symbol) -> bool:
    """Return whether a symbol depends on the state, not only on time."""
    pending, seen = [symbol], set[int]()
    while pending:
        part = pending.pop()
        if not part.arguments and part.name != "t":
            return True
        seen.add(part.number)
        pending += [a for a in part.arguments if isinstance(a, Symbol) and a.number not in seen]
    return False


def _bound_of(name: str, z: str, arguments: list[tuple[str, str]]) -> str:
    """Return source of the bound of z = name(arguments); arguments : pairs of text and bound, empty if exact."""
    of_z = "" if name in ("neg", "fabs") else f"{UNIT_ROUNDOFF if name in '+-*/' else 2 * UNIT_ROUNDOFF!r} * abs({z})"
    (x, dx), (y, dy) = (*arguments, ("", ""))[:2]
    if name in ("+", "-", "neg", "fabs"):
        parts = [dx, dy]
    elif name == "*":
        parts = [dx and f"abs({y}) * {dx}", dy and f"abs({x}) * {dy}"]
    elif name == "/":
        parts = [dx and f"{dx} / abs({y})", dy and f"abs({z} / {y}) * {dy}"]
    else:  # by evaluation at the shifted argument, since a derivative may be infinite
        shifted = [f"{a} + {d}" if d else a for a, d in arguments]
        parts = [f"abs({name}({', '.join(shifted)}) - {z})"]
    return " + ".join(filter(None, (*parts, of_z))) or "0.0"


def uses_of(operations: Sequence[Symbol], rates: Sequence[Value]) -> list[int]:
    """Return how often each symbol is used; 0 if no rate depends on it."""
    uses = [0] * len(operations)
    for value in rates:
        if isinstance(value, Symbol):
            uses[value.number] += 1
    for symbol in reversed(operations):
        for argument in symbol.arguments if uses[symbol.number] else ():
            if isinstance(argument, Symbol):
                uses[argument.number] += 1
    return uses


def _expression(name: str, arguments: list[str]) -> str:
    if not arguments:
        return name
    if name == "neg":
        return f"(-{arguments[0]})"
    if name in ("+", "-", "*", "/"):
        return f"({arguments[0]} {name} {arguments[1]})"
    return f"{name}({', '.join(arguments)})"
