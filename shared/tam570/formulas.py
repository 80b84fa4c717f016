"""What students return in the place of a SymPy expression, told apart in the same way by `check` and by the grader."""

from tam570.values import Numbers

__all__ = ["REMEDIES", "form_of"]

REMEDIES = {  # what to do instead
    "an equation": "Return one side of it, such as equation.rhs.",
    "a list": "sympy.solve returns a list; return the expression in it, such as solve(...)[0].",
    "a matrix": "Return the expression in it, such as matrix[0].",
    "a dict": "Return the value of the unknown, such as solution[alpha].",
    "text": "Return the expression itself, without quotes.",
    "a function": "Return the expression itself, without lambda or lambdify.",
    "None": "Is a `return` missing?",
}


def form_of(result: Numbers) -> str:
    """Return which of REMEDIES a result is, or another object; "" for an expression or a number."""
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
