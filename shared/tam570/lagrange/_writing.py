"""Write the equations as straight-line Python on floats, without repeated subexpressions or terms that are zero.

Symbols stand for intermediate results and have the names of their variables in the text. Linear systems are solved by
elimination without exchange of rows: the mass matrix of a system with inertia in every coordinate is positive definite,
and so is A M^-1 A^T of independent constraints. An indefinite one that needs exchanges is refused before.
"""

import keyword
from collections.abc import Iterable, Sequence

import sympy
from sympy.printing.pycode import PythonCodePrinter

from tam570.lagrange import Expression
from tam570.lagrange._derivation import EquationsOfMotion

Lines = list[str]
System = list[list[Expression]]


def module(motion: EquationsOfMotion) -> str:
    """Return the text of the module."""
    _check_names(motion)
    functions = [
        _function(
            motion,
            "rhs",
            "The rates of the state.",
            lambda m, lines: _tuple(lines, [*m.velocities, *_solution(m, lines)[0]]),
        ),
        _function(motion, "mass_matrix", "M, by rows.", lambda m, lines: _rows(lines, m.mass)),
        _function(motion, "forcing", "F.", lambda m, lines: _tuple(lines, _values(lines, m.forcing))),
        _function(motion, "energy", "Jacobi's integral.", lambda m, lines: _text(lines, _values(lines, [m.energy])[0])),
    ]
    if motion.matrix:
        errors = "The holonomic constraints, then the rates of all."
        functions += [
            _function(motion, "constraint_matrix", "A, by rows.", lambda m, lines: _rows(lines, m.matrix)),
            _function(motion, "multipliers", "lam.", lambda m, lines: _tuple(lines, _solution(m, lines)[1])),
            _function(motion, "constraint_errors", errors, lambda m, lines: _tuple(lines, _values(lines, m.errors))),
        ]
    names = ", ".join(map(str, motion.coordinates))
    preamble = (
        f'"""Equations of motion in {names}; written by tam570.lagrange, not to be edited."""\n\nimport math\n\n'
        f"STATE = {tuple(map(str, motion.coordinates + motion.velocities))}\n"
        f"PARAMETERS = {tuple(map(str, motion.parameters))}"
    )
    return "\n\n\n".join([preamble, *functions]) + "\n"


def _function(motion: EquationsOfMotion, name: str, summary: str, result: Expression) -> str:
    """Return a function's text; result(motion, lines) appends lines to its body and returns its `return` expression."""
    parameters = ", ".join(["*", *map(str, motion.parameters)]) if motion.parameters else ""
    signature = ", ".join(filter(None, [str(motion.time), "state", parameters]))
    lines = [f"{', '.join(map(str, motion.coordinates + motion.velocities))} = state"]
    lines.append(f"return {result(motion, lines)}")
    return f'def {name}({signature}):\n    """{summary}"""\n    ' + "\n    ".join(lines)


def _solution(motion: EquationsOfMotion, lines: Lines) -> tuple[list[Expression], list[Expression]]:
    """Return accelerations and multipliers, lam from A M^-1 A^T lam = -(bias + A M^-1 F)."""
    n, c = len(motion.coordinates), len(motion.matrix)
    entries = [*sum(motion.mass, ()), *motion.forcing, *sum(motion.matrix, ()), *motion.bias]
    numbers = iter(_named(lines, _values(lines, entries if c else _cancelled(entries, motion.parameters))))
    mass = [[next(numbers) for _ in range(n)] for _ in range(n)]
    forcing = [next(numbers) for _ in range(n)]
    matrix = [[next(numbers) for _ in range(n)] for _ in range(c)]
    bias = list(numbers)
    free, *pushed = _solved(lines, mass, [forcing, *matrix])
    if not c:
        return free, []
    compliance = [_named(lines, [_dot(row, column) for column in pushed]) for row in matrix]
    missing = _named(lines, [-b - _dot(row, free) for b, row in zip(bias, matrix, strict=True)])
    (multipliers,) = _solved(lines, compliance, [missing])
    rows = zip(free, *pushed, strict=True)
    return _named(lines, [first + _dot(row, multipliers) for first, *row in rows]), multipliers


def _cancelled(entries: Sequence[Expression], parameters: Sequence[Expression]) -> list[Expression]:
    """Return the entries of M and F without parameters that are factors of all of them, such as a single mass."""
    factored = [sympy.factor_terms(entry) for entry in entries]
    powers = [entry.as_powers_dict() for entry in factored if entry != 0]
    exponents = {p: [sympy.sympify(power.get(p, 0)) for power in powers] for p in parameters}
    common = [p ** min(several) for p, several in exponents.items() if all(e.is_Integer for e in several)]
    return [entry / sympy.Mul(*common) for entry in factored]


def _solved(lines: Lines, matrix: System, columns: System) -> System:
    """Solve a symmetric system by elimination without exchange of rows, for several right-hand columns."""
    upper, columns = [list(row) for row in matrix], [list(column) for column in columns]
    size = len(upper)
    for k in range(size):
        for i in range(k + 1, size):
            if upper[k][i] != 0:
                (factor,) = _named(lines, [upper[k][i] / upper[k][k]])
                upper[i][i:] = _named(lines, [a - factor * b for a, b in zip(upper[i][i:], upper[k][i:], strict=True)])
                for column in columns:
                    column[i : i + 1] = _named(lines, [column[i] - factor * column[k]])
    for column in columns:
        for k in reversed(range(size)):
            rest = column[k] - _dot(upper[k][k + 1 :], column[k + 1 :])
            column[k : k + 1] = _named(lines, [rest / upper[k][k]])
    return columns


def _dot(row: Sequence[Expression], column: Sequence[Expression]) -> Expression:
    return sum((a * b for a, b in zip(row, column, strict=True)), sympy.Integer(0))


def _named(lines: Lines, expressions: Iterable[Expression]) -> list[Expression]:
    """Return symbols for expressions that need operations; numbers, symbols and negated symbols stay."""
    return [e if e.is_Number or (-e).is_Symbol or e.is_Symbol else _symbol(lines, _text(lines, e)) for e in expressions]


def _values(lines: Lines, expressions: Sequence[Expression]) -> list[Expression]:
    """Write lines for common subexpressions; return the expressions in terms of these."""
    shared, results = sympy.cse(expressions, symbols=sympy.numbered_symbols(cls=sympy.Dummy))
    names: dict[Expression, Expression] = {}
    for symbol, expression in shared:
        names[symbol] = _symbol(lines, _text(lines, expression.xreplace(names)))
    return [sympy.sympify(result).xreplace(names) for result in results]


def _text(lines: Lines, expression: Expression) -> str:
    """Return the text of an expression; bases of small integer powers get names, so that x**2 can be written x*x."""
    for power in sorted(expression.atoms(sympy.Pow), key=sympy.default_sort_key):
        if _is_product(power) and not power.base.is_Symbol and expression.has(power):
            base = _symbol(lines, _text(lines, power.base))
            expression = expression.xreplace({power: sympy.Pow(base, power.exp)})
    try:
        text = str(_PRINTER.doprint(expression))
    except NotImplementedError as error:
        raise ValueError(f"no function of math computes {expression}") from error
    if "#" in text:  # SymPy before 1.13 writes a comment instead of raising
        raise ValueError(f"no function of math computes {expression}")
    return text


def _is_product(power: Expression) -> bool:
    return bool(power.exp.is_Integer and 2 <= abs(power.exp) <= 4)


class _Printer(PythonCodePrinter):  # type: ignore[misc]  # SymPy's classes carry no types
    """SymPy's printer with small integer powers as products: x*x takes a quarter of the time of x**2."""

    def _print_Pow(self, expr: Expression, rational: bool = False) -> str:
        if not _is_product(expr) or not expr.base.is_Symbol:
            return str(super()._print_Pow(expr, rational=rational))
        product = "(" + "*".join([self._print(expr.base)] * abs(int(expr.exp))) + ")"
        return product if expr.exp > 0 else f"(1/{product})"


_PRINTER = _Printer()


def _symbol(lines: Lines, text: str) -> Expression:
    """Write a line that assigns the text to a new name; return its symbol."""
    name = f"_{len(lines)}"
    lines.append(f"{name} = {text}")
    return sympy.Symbol(name)


def _tuple(lines: Lines, numbers: Iterable[Expression]) -> str:
    return _joined("0.0" if number == 0 else _text(lines, number) for number in numbers)


def _rows(lines: Lines, matrix: Sequence[Sequence[Expression]]) -> str:
    numbers = iter(_values(lines, [entry for row in matrix for entry in row]))
    return _joined([_tuple(lines, [next(numbers) for _ in row]) for row in matrix])


def _joined(texts: Iterable[str]) -> str:
    texts = list(texts)
    return f"({', '.join(texts)}{',' if len(texts) == 1 else ''})"


def _check_names(motion: EquationsOfMotion) -> None:
    """Raise ValueError if a symbol's name is not valid in the text, or two symbols have the same name."""
    names = [str(s) for s in (motion.time, *motion.coordinates, *motion.velocities, *motion.parameters)]
    for name in names:
        if not name.isidentifier() or keyword.iskeyword(name) or name in ("math", "state") or name[0] == "_":
            raise ValueError(f"symbol {name!r} cannot be a name in Python here: give it another one")
        if names.count(name) > 1:
            raise ValueError(f"symbol {name!r} stands for two things: give one another name")
