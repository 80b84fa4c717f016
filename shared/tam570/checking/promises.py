"""Whether a result has the form that the assignment promises, in words that help."""

from collections.abc import Sequence

from tam570.formulas import REMEDIES, form_of
from tam570.loading import Trouble
from tam570.show.student import numbers, rows_missing
from tam570.values import Json, Numbers

__all__ = ["Promise", "complaint"]

# {"array": [3, 3]}, {"group": [...]}, {"formula": ["theta", ...]}, {"diagram": 2} or {"drawing": true}
Promise = Json
FINITE = "gives NaN or infinity"
STAND_INS = 1.25, 3.75  # for symbols that may cancel


def complaint(returns: Promise, result: Numbers, name: str, arguments: Sequence[Numbers]) -> str | None:
    """Return what is wrong with the form of a result; None if nothing is.

    arguments : of the call; as many rows as the first has elements are promised by "n"
    """
    try:
        if "group" in returns:
            _members(returns["group"], result, name, arguments)
        elif "array" in returns:
            _array(returns, result, name, arguments)
        elif "diagram" in returns:
            _diagram(returns["diagram"], result, name)
        elif "formula" in returns:
            _formula(returns["formula"], result, name)
    except Trouble as trouble:
        return str(trouble) if str(trouble).endswith(("?", ".")) else f"{trouble}."
    return None


def _members(promises: Sequence[Promise], result: Numbers, name: str, arguments: Sequence[Numbers]) -> None:
    import numpy as np

    if result is None:
        raise Trouble(f"{name} gives None. Is a `return` missing?")
    several = isinstance(result, list | tuple) or isinstance(result, np.ndarray) and result.ndim > 0
    if not several or len(result) != len(promises):
        came = f"{len(result)} results" if several else _short(result)
        raise Trouble(f"{name} gives {came}; {len(promises)} results are asked for, as in `return a, b`")
    for index, (returns, member) in enumerate(zip(promises, result, strict=True), start=1):
        _array(returns, member, f"{name} (result {index})", arguments)


def _array(returns: Promise, result: Numbers, name: str, arguments: Sequence[Numbers]) -> None:
    import numpy as np

    if result is None:
        raise Trouble(f"{name} gives None. Is a `return` missing?")
    values = numbers(name, result, None)
    shape = [len(arguments[0]) if size == "n" else size for size in returns["array"]]
    fits = len(shape) == values.ndim and all(a in (None, b) for a, b in zip(shape, values.shape, strict=False))
    if not fits:
        wanted = f"an array of shape {_shape(shape)}" if shape else "a single number"
        came = f"an array of shape {_shape(values.shape)}" if values.ndim else "a single number"
        raise Trouble(f"{name} gives {came}; {wanted} is asked for{rows_missing(values, shape)}")
    if np.isnan(values).any() or not returns.get("infinite") and np.isinf(values).any():
        raise Trouble(f"{name} {FINITE}")


def _diagram(dimension: int, result: Numbers, name: str) -> None:
    """Require a list of pairs (point, direction) of so many numbers; the direction may be None."""
    try:
        pairs = [(point, direction) for point, direction in result]
    except (TypeError, ValueError):
        raise Trouble(f"{name} gives {_short(result)}; a list of pairs (point, direction) is asked for") from None
    for point, direction in pairs:
        _array({"array": [dimension]}, point, f"{name} (a point)", ())
        if direction is not None:
            _array({"array": [dimension]}, direction, f"{name} (a direction)", ())


def _formula(symbols: Sequence[str], result: Numbers, name: str) -> None:
    import sympy

    if form := form_of(result):
        instead = f". {REMEDIES[form]}" if form in REMEDIES else ""
        wanted = f"a SymPy expression in {', '.join(symbols)} is asked for{instead}"
        raise Trouble(f"{name} gives {form}; {wanted}")
    unknown = {symbol for symbol in sympy.sympify(result).free_symbols if symbol.name not in symbols}
    values = {_value(result, unknown, number) for number in STAND_INS} if unknown else set()
    if len(values) > 1:  # it does not cancel
        names = ", ".join(sorted(symbol.name for symbol in unknown))
        raise Trouble(f"{name} depends on {names}; an expression in {', '.join(symbols)} alone is asked for")


def _value(expression: Numbers, unknown: set[Numbers], number: float) -> str:
    """Return the value to ten digits where the strangers have this number, and the others 0.7."""
    values = {symbol: number if symbol in unknown else 0.7 for symbol in expression.free_symbols}
    return f"{complex(expression.evalf(20, subs=values)):.10g}"


def _shape(sizes: Sequence[int | None]) -> str:
    return f"({', '.join('k' if size is None else str(size) for size in sizes)}{',' if len(sizes) == 1 else ''})"


def _short(result: Numbers) -> str:
    text = " ".join(repr(result).split())
    return text if len(text) <= 60 else f"{text[:57]}..."
