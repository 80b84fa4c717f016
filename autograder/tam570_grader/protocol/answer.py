"""Call a student's function and turn its result into plain data: numbers, values of a formula, or a drawing."""

import builtins
import random
from collections.abc import Callable, Iterator
from types import ModuleType

import numpy as np
import numpy.polynomial  # before the fork, as the next: NumPy imports both lazily
import numpy.random

from tam570.bans import IN_ONE, Change, Unusable, everywhere, refused
from tam570.formulas import form_of, unknown_symbols, values_at
from tam570.values import Function, Json, Numbers

from .picture import picture
from .wire import LONGEST_TEXT, portable

__builtins__ = dict(vars(builtins))  # type: ignore[assignment]  # as in wire


def answers(module: ModuleType, request: Json) -> Iterator[Json]:
    """Yield the reply to each call: {"value": ..., "changed": whether arguments changed} or {"error": ...}."""
    try:
        replaced = _stood_in(module, request)
    except Exception as error:  # a file's `__getattr__` may raise anything
        yield from [{"error": error_report(error)}] * len(request["calls"])
        return
    try:
        for args, kwargs in request["calls"]:
            yield _answer(module, request, args, kwargs)
    finally:
        for owner, name, was in replaced:
            setattr(owner, name, was)


def _answer(module: ModuleType, request: Json, args: list[Numbers], kwargs: Json) -> Json:
    args, kwargs = [*map(_own, args)], {key: _own(argument) for key, argument in kwargs.items()}
    try:
        function = getattr(module, request["function"])
        before = _contents(args, kwargs)
        value = MODES[request["mode"]](function, args, kwargs, request)
        return {"value": value, "changed": _contents(args, kwargs) != before}
    except BaseException as error:
        return {"error": error_report(error)}


def _own(argument: Numbers) -> Numbers:
    """Return a writable copy of an array, a list of lists as a list of tuples, a number unchanged."""
    if type(argument) is float:
        return argument
    if isinstance(argument, list):
        return [tuple(item) if isinstance(item, list) else item for item in argument]
    return argument.copy() if hasattr(argument, "copy") else argument


def error_report(error: BaseException) -> Json:
    """Return the names of an exception's classes, its text, and the line of the student's file in which it was raised.

    The line is 0 if it was raised elsewhere.
    """
    line, trace = 0, error.__traceback__
    while trace is not None:
        if not trace.tb_frame.f_code.co_filename.startswith(("/", "<")):
            line = trace.tb_lineno
        trace = trace.tb_next
    if isinstance(error, SyntaxError):
        line = error.lineno or 0
    return {
        "kinds": [error_class.__name__[:50] for error_class in type(error).__mro__[:20]],
        "text": _text(error),
        "line": line,
    }


def _stood_in(module: ModuleType, request: Json) -> list[Change]:
    """Replace refused functions of the file, and the one to move, under all their names; return what to restore.

    The function to call is not replaced, even if it is a refused function under another name.
    """
    if not request["refused"] and not request.get("moved"):
        return []
    target = getattr(module, request["function"])
    names = (name for name in request["refused"] if getattr(module, name, target) is not target)
    changes = [change for name in names for change in refused(module, name, Unusable(name, IN_ONE))]
    if name := request.get("moved"):
        homes: list[ModuleType | type] = [module, *(each for each in vars(module).values() if isinstance(each, type))]
        for home in homes:
            if callable(function := vars(home).get(name)) and not isinstance(function, staticmethod):
                changes += everywhere(home, function, _moved(function, *request.get("scaled", ())))
    originals = [(owner, attribute, getattr(owner, attribute)) for owner, attribute, _ in changes]
    for owner, attribute, value in changes:
        setattr(owner, attribute, value)
    return originals


def _moved(function: Function, index: int = -1, factor: float = 0.0) -> Function:
    """Return the function with all its results larger by one; if it is a method, so is the returned function.

    index, factor : of one number of its result, or -1 for all, and a factor by which to multiply it instead; 0: none
    """
    if factor:
        return lambda *args, **kwargs: _scaled(function(*args, **kwargs), index, factor)
    return lambda *args, **kwargs: _larger(function(*args, **kwargs))


def _scaled(result: Numbers, index: int, factor: float) -> Numbers:
    if isinstance(result, tuple):
        return tuple(part * factor if index in (-1, k) else part for k, part in enumerate(result))
    scaled = np.array(result, float)
    if index == -1:
        return scaled * factor
    scaled[np.unravel_index(index, scaled.shape)] *= factor
    return scaled


def _larger(result: Numbers) -> Numbers:
    if isinstance(result, dict):
        return {key: _larger(value) for key, value in result.items()}
    return tuple(map(_larger, result)) if isinstance(result, tuple) else np.asarray(result) + 1.0


def seed_generators() -> None:
    """Seed the global random generators with the same seed for every submission, so that scores are reproducible."""
    random.seed(0)
    np.random.seed(0)  # noqa: NPY002  the global state is what students use


def _text(error: BaseException) -> str:
    try:
        return str(error)[:LONGEST_TEXT]
    except BaseException:
        return ""


def _contents(args: list[Numbers], kwargs: Json) -> list[Numbers]:
    """Return the current content of arrays and lists among the arguments, as bytes and text because NaN != NaN."""
    arguments = [argument for argument in (*args, *kwargs.values()) if type(argument) is not float]
    return [argument.tobytes() if isinstance(argument, np.ndarray) else repr(argument) for argument in arguments]


def _formula(function: Function, args: list[Numbers], kwargs: Json, request: Json) -> Numbers:
    """Return the values at the request's points of the SymPy expression that the function returns.

    Symbols are matched by name. Other symbols are allowed if they cancel, so that the values do not depend on them.
    """
    import sympy

    expression = function(*args, **kwargs)
    if form := form_of(expression):
        return {"form": form}
    expression = sympy.sympify(expression).doit()
    if names := unknown_symbols(expression, request["symbols"], request["points"]):
        return {"strangers": names}
    return [portable(value) for value in values_at(expression, request["points"])]


def evaluate_a_formula() -> None:
    """Evaluate a formula, so that SymPy imports all modules that differentiation and evaluation need."""
    import sympy

    x, y = sympy.symbols("x y")
    expression = sympy.cancel(sympy.diff(y**2 * sympy.cos(x), x) / y)
    values_at(expression, [{"x": 0.5, "y": 2.0}])


MODES: dict[str, Callable[[Function, list[Numbers], Json, Json], Numbers]] = {
    "value": lambda function, args, kwargs, request: portable(function(*args, **kwargs)),
    "formula": _formula,
    "drawing": lambda function, args, kwargs, request: picture(
        function, args, kwargs, looked_at=not request.get("moved")
    ),
}
