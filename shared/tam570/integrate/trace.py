"""A right-hand side specialised to its scene: call it once with symbols instead of numbers, write down what it did.

Parameters are numbers already, so what depends on them alone is computed here and now; a factor of zero takes its
term along; what occurs twice is computed once. A function that asks what a number is (a comparison, a loop until
convergence, a compiled routine) cannot be written down like this and is called as it stands.
"""

import functools
import math
import types
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from tam570.integrate.cache_key import global_names
from tam570.integrate.symbols import FUNCTIONS, Symbol, Tape, Untraceable, Value

__all__ = ["Graph", "traced"]

# What Python, NumPy and a careful function answer to an argument that is not a number.
ANSWERS = (TypeError, ValueError, AttributeError, ArithmeticError, LookupError, AssertionError, RuntimeError)


BUILTINS = "built-in names"  # what a translation knows beside functions


@dataclass(frozen=True, eq=False)
class Graph:
    """What a right-hand side does to time and state: each operation after those whose results it takes.

    operations : symbols; the first are "t", "s0", "s1", ..., without arguments; `number` is the index in this list
    rates      : one a component, a symbol or a number
    """

    operations: tuple[Symbol, ...]
    rates: tuple[Value, ...]


def traced(rates: Callable[..., Any], size: int, stand_ins: Mapping[str, Any] | None = None) -> Graph:
    """Return what rates(t, y) computes. Raises Untraceable, with the reason.

    stand_ins : by name, what functions find in the place of built-in ones, such as `float`
    """
    tape = Tape()
    time, state = tape.record("t"), [tape.record(f"s{i}") for i in range(size)]
    try:
        values = _translated(rates, {BUILTINS: stand_ins or {}})(time, np.array(state))
        listed = tuple(v if isinstance(v, Symbol) else float(v) for v in values)
    except Exception as answer:
        raise _refusal(answer) from answer
    return Graph(tuple(tape.symbols.values()), listed)


def _refusal(answer: Exception) -> Exception:
    """Return why the function does not take symbols; another error than these is its own."""
    cause: BaseException | None = answer
    while cause is not None:
        if isinstance(cause, Untraceable):  # the function may have made another error of it
            return Untraceable(str(cause))
        cause = cause.__cause__ or cause.__context__
    return Untraceable(f"{type(answer).__name__}: {answer}") if isinstance(answer, ANSWERS) else answer


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
        if name == "log" and len(arguments) == 2:
            return either(arguments[0]) / either(arguments[1])
        if name == "hypot" and len(arguments) > 2:
            return either(either(*arguments[:2]), *arguments[2:])
        if name == "hypot" and len(arguments) == 1:
            return abs(symbol)
        return arguments[0] ** arguments[1] if name == "pow" else symbol.tape.record(name, *arguments)

    return either


def _checked_isinstance(value: Any, kinds: Any) -> bool:
    """Of a number that is not known yet nobody can say whether it is a float."""
    if isinstance(value, Symbol):
        raise Untraceable("depends on the type of the state's components")
    return isinstance(value, kinds)


def _translated(value: Any, twins: dict[int | str, Any]) -> Any:
    """Return `value` with math replaced by its symbolic kin, in all the functions that it calls."""
    if value is math:
        return _Mathematics()
    if isinstance(value, types.BuiltinFunctionType):
        return _symbolic(value) if value.__module__ == "math" else value
    if isinstance(value, functools.partial):
        return functools.partial(_translated(value.func, twins), *value.args, **value.keywords)
    if isinstance(value, types.MethodType):
        return types.MethodType(_translated(value.__func__, twins), value.__self__)
    if isinstance(value, types.FunctionType) and not (value.__module__ or "").startswith("numpy"):
        return twins[id(value)] if id(value) in twins else _translated_function(value, twins)
    return value


def _translated_function(function: types.FunctionType, twins: dict[int | str, Any]) -> types.FunctionType:
    names = {**twins[BUILTINS], **function.__globals__}
    cells = tuple(types.CellType() for _ in function.__closure__ or ())
    twin = types.FunctionType(function.__code__, names, function.__name__, function.__defaults__, cells)
    twin.__kwdefaults__ = function.__kwdefaults__
    twins[id(function)] = twin  # before its names are looked at: it may call itself
    for name in global_names(function.__code__) & names.keys():
        names[name] = _translated(names[name], twins)
    if "isinstance" in function.__code__.co_names and "isinstance" not in names:
        names["isinstance"] = _checked_isinstance
    for cell, original in zip(cells, function.__closure__ or (), strict=True):
        cell.cell_contents = _translated(original.cell_contents, twins)
    return twin
