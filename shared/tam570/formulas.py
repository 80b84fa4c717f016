"""Classify what students return instead of a SymPy expression, for both `check` and the grader."""

from collections.abc import Mapping, Sequence

from tam570.values import Numbers

STAND_INS = 1.25, 3.75  # values of symbols that may cancel
CANCELLED = 1e-13  # relative; values are computed with 25 digits, then rounded
NOTHING = 1e-60  # above the rounding of an expression that is zero, computed with up to 100 digits
REMEDIES = {  # by the form of a result: what to do instead
    "an equation": "Return one side of it, such as equation.rhs.",
    "a list": "sympy.solve returns a list; return the expression in it, such as solve(...)[0].",
    "a matrix": "Return the expression in it, such as matrix[0].",
    "a dict": "Return the value of the unknown, such as solution[alpha].",
    "text": "Return the expression itself, without quotes.",
    "a function": "Return the expression itself, without lambda or lambdify.",
    "None": "Is a `return` missing?",
}


def form_of(result: Numbers) -> str:
    """Return the form of a result, a key of REMEDIES, "an array" or "an object"; "" for an expression or a number."""
    import sympy
    from sympy.core.relational import Relational

    kinds: dict[str, type | tuple[type, ...]] = {
        "an equation": Relational,
        "a list": (list, tuple, set, sympy.Tuple, sympy.Set),
        "a matrix": (sympy.MatrixBase, sympy.MatrixExpr),
        "a dict": (dict, sympy.Dict),
        "text": str,
        "None": type(None),
        "a function": sympy.Lambda,
    }
    for form, classes in kinds.items():
        if isinstance(result, classes):
            return form
    if isinstance(result, sympy.Expr | int | float):
        return ""
    if hasattr(result, "__array__"):
        return "an array" if result.ndim else ""
    return "a function" if callable(result) else "an object"


def unknown_symbols(expression: Numbers, symbols: Sequence[str], points: Sequence[Mapping[str, float]]) -> list[str]:
    """Return the undefined functions in an expression, else the symbols that are not in `symbols` and do not cancel."""
    from sympy.core.function import AppliedUndef

    if functions := expression.atoms(AppliedUndef):
        return sorted(map(str, functions))
    names = sorted({symbol.name for symbol in expression.free_symbols} - set(symbols))
    first, other = ([] if not names else values_at(expression, points, stand_in) for stand_in in STAND_INS)
    cancel = all(abs(a - b) <= max(CANCELLED * abs(a), NOTHING) for a, b in zip(first, other, strict=True))
    return [] if cancel else names


def values_at(
    expression: Numbers, points: Sequence[Mapping[str, float]], stand_in: float = STAND_INS[0]
) -> list[complex]:
    """Return the values at points {symbol's name: number}; the other symbols are `stand_in` plus different integers."""
    names = {symbol: symbol.name for symbol in expression.free_symbols}
    others = {name: stand_in + number for number, name in enumerate(sorted(set(names.values())))}
    return [
        complex(expression.evalf(25, subs={symbol: {**others, **point}[name] for symbol, name in names.items()}))
        for point in points
    ]
