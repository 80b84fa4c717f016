"""A right-hand side specialised to its scene: call it once with symbols instead of numbers, write down what it did.

Parameters are numbers already, so what depends on them alone is computed here and now; a factor of zero takes its
term along; what occurs twice is computed once. A function that asks what a number is (a comparison, a loop until
convergence, a compiled routine) cannot be written down like this and is called as it stands.
"""

import contextlib
import dis
import functools
import math
import types
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from tam570.integrate.cache_key import global_names
from tam570.integrate.symbols import FUNCTIONS, Symbol, Tape, Untraceable, Value
from tam570.values import Function, Numbers, Parameters

__all__ = ["Graph", "substituted", "traced"]

# What Python, NumPy and a careful function answer to an argument that is not a number.
ANSWERS = (TypeError, ValueError, AttributeError, ArithmeticError, LookupError, AssertionError, RuntimeError)


@dataclass(frozen=True, eq=False)
class Graph:
    """What a right-hand side does to time and state: each operation after those whose results it takes.

    operations : symbols; the first are "t", "s0", "s1", ..., without arguments; `number` is the index in this list
    rates      : one a component, a symbol or a number
    """

    operations: tuple[Symbol, ...]
    rates: tuple[Value, ...]


def traced(rates: Function, size: int, stand_ins: Parameters | None = None) -> Graph:
    """Return what rates(t, y) computes. Raises Untraceable, with the reason.

    stand_ins : by name, what functions find in the place of built-in ones, such as `float`
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
    """Return why the function does not take symbols; another error than these is its own."""
    cause: BaseException | None = answer
    while cause is not None:
        if isinstance(cause, Untraceable):  # the function may have made another error of it
            return Untraceable(str(cause))
        cause = cause.__cause__ or cause.__context__
    return Untraceable(f"{type(answer).__name__}: {answer}") if isinstance(answer, ANSWERS) else answer


class _Mathematics:
    """The module math for symbols; numbers go to the real one."""

    def __getattr__(self, name: str) -> Numbers:
        return _symbolic(getattr(math, name))


def _symbolic(function: Function) -> Numbers:
    name = getattr(function, "__name__", "")
    if name not in FUNCTIONS and name != "pow":
        return function

    def either(*arguments: Numbers) -> Numbers:
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


def _checked_isinstance(value: Numbers, kinds: Numbers) -> bool:
    """Of a number that is not known yet nobody can say whether it is a float."""
    if isinstance(value, Symbol):
        raise Untraceable("depends on the type of the state's components")
    return isinstance(value, kinds)


STAND_INS = {"isinstance": _checked_isinstance}


def _substitute(value: Numbers) -> Numbers:
    """Return what stands in for math and its functions."""
    if value is math:
        return _Mathematics()
    return _symbolic(value) if isinstance(value, types.BuiltinFunctionType) and value.__module__ == "math" else value


def substituted(
    value: Numbers,
    substitute: Callable[[Numbers], Numbers],
    stand_ins: Parameters,
    twins: dict[int, types.FunctionType] | None = None,
) -> Numbers:
    """Return a function that finds other values in the place of those that it uses, as all functions that it calls do.

    substitute : of a value, what is found in its place; the value itself if nothing is
    stand_ins  : the same by name, for built-in names
    twins      : of functions, by their id; one may call itself
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
    sets_items = any(line.opname == "STORE_SUBSCR" for line in dis.get_instructions(value.__code__))
    twins[id(value)] = twin  # before its names are looked at: it may call itself

    def stand_in(used: Numbers) -> Numbers:
        """Copy lists and arrays: what the function puts there stays its own."""
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
        with contextlib.suppress(ValueError):  # it has no value yet
            cell.cell_contents = stand_in(original.cell_contents)
    twin.__defaults__, twin.__kwdefaults__ = stand_in(value.__defaults__), stand_in(value.__kwdefaults__)
    return twin
