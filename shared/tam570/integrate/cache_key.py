"""Hashable keys of functions: functions with equal keys compute the same.

A key contains code, defaults, and the values in closures and globals, also of all functions that are called. Only
functions that evidently compute numbers from numbers have a key and are traced: they compare no identities, catch no
errors except CAUGHT, keep no state between calls, and use only the names listed here. All others are called.
"""

import dis
import functools
import math
import operator
import types
from collections.abc import Callable, Hashable, Iterable
from functools import lru_cache
from typing import Any, TypeAlias

import numpy as np

from tam570.values import Function, Parameters

Captured: TypeAlias = Any  # an object that a right-hand side refers to

LONGEST = 1000  # items of a list or array, at most: with more, the key takes longer than the trace
CONSTANT = ("math", "numpy")  # modules that do not change
TRUSTED = ("tam570.arguments", "tam570.meter")  # modules of this package that validate parameters or count steps


def _words(text: str) -> frozenset[str]:
    return frozenset(text.split())


PURE_BUILTINS = _words(
    """abs all any bool repr divmod enumerate filter float int len list map max min pow range reversed round set slice
    sorted sum tuple zip isinstance True False None ValueError TypeError ArithmeticError
    ZeroDivisionError RuntimeError"""
)
MATH = frozenset(name for name in dir(math) if name[0] != "_")
ARRAY_FUNCTIONS = _words(
    """abs absolute add append arange arccos arccosh arcsin arcsinh arctan arctan2 arctanh array asarray atleast_1d
    block cbrt column_stack concatenate copy cos cosh cross cumsum deg2rad degrees diag diagonal diff divide dot e
    einsum empty exp expm1 eye fabs float64 full hstack hypot identity inf inner linspace log log10 log1p log2 matmul
    mean multiply nan negative newaxis ones outer pi power prod radians rad2deg ravel repeat reshape roll sin sinh size
    sqrt square stack subtract sum tan tanh tile trace transpose true_divide vdot vstack zeros"""
)
METHODS = _words(
    """T all any astype copy cumsum diagonal dot flatten floating format integer items join keys max min ndarray ndim
    prod ravel reshape round shape size sum tolist values"""
)
CHANGING = _words("append extend insert fill")  # methods that modify; see `Reach.changes`
ATTRIBUTES = MATH | ARRAY_FUNCTIONS | METHODS | CHANGING
CAUGHT = _words("ValueError ArithmeticError ZeroDivisionError OverflowError")  # errors that a symbol never raises
FORBIDDEN = _words(
    """STORE_GLOBAL DELETE_GLOBAL STORE_ATTR DELETE_ATTR IMPORT_NAME IMPORT_FROM LOAD_NAME STORE_NAME BEFORE_WITH
    WITH_EXCEPT_START LOAD_SPECIAL LOAD_BUILD_CLASS MATCH_CLASS LOAD_SUPER_ATTR GET_AWAITABLE"""
)  # bytecode instructions


class Changeable(Exception):
    """Raised if a function has no key, because something that it depends on may change unnoticed."""


class Reach:
    """The functions behind a key and all that they refer to, to recognize unchanged ones without a new key."""

    def __init__(self) -> None:
        self.numbers: dict[int, int] = {}  # number of each function by its id, for recursive calls
        self.functions: list[tuple[types.FunctionType, types.CodeType, Captured]] = []
        self.cells: list[tuple[types.CellType, Captured]] = []
        self.names: list[tuple[dict[str, Captured], str, Captured]] = []
        self.has_lists = False  # whether they refer to lists, arrays or dicts
        self.changes = False  # whether code modifies objects; allowed only without such data
        self.is_fixed = True  # whether the same objects always have the same key
        self.key: Hashable = None
        self.parameters: tuple[tuple[str, ...], tuple[Captured, ...], Hashable] | None = None  # and the key with them

    def is_same(self) -> bool:
        """Return whether all functions still refer to the same objects as when the key was computed."""
        for function, code, defaults in self.functions:
            if function.__code__ is not code or function.__defaults__ is not defaults or function.__kwdefaults__:
                return False
        for table, name, value in self.names:
            if table.get(name, Reach) is not value:
                return False
        try:
            return all(cell.cell_contents is content for cell, content in self.cells)
        except ValueError:  # a cell has become empty
            return False


def cache_key(value: Captured, reach: Reach | None = None) -> Hashable:
    """Return the key of a value, or raise `Changeable` if it has none. reach : records what the key depends on."""
    read = READERS.get(type(value))
    if read:
        return read(value, Reach() if reach is None else reach)
    if isinstance(value, np.generic):
        return type(value), value.tobytes()
    if isinstance(value, type) and value.__module__ in ("builtins", "numpy"):
        return value
    raise Changeable(f"{type(value).__name__} may change unseen")


def call_key(rhs: Function, parameters: Parameters | None) -> Hashable:
    """Return the key of a right-hand side with its parameters, or raise `Changeable` if it has none."""
    if parameters and not hasattr(parameters, "values"):
        raise Changeable("parameters that are no mapping")
    last = _last.get(rhs) if isinstance(rhs, types.FunctionType) else None
    if last is not None and last.is_same():
        if not parameters:
            return last.key
        if last.parameters is not None:
            names, values, key = last.parameters
            if tuple(parameters) == names and all(map(operator.is_, parameters.values(), values)):
                return key
    reach = Reach()
    key = of_rhs = cache_key(rhs, reach)
    is_fixed = reach.is_fixed
    if parameters:
        key = of_rhs, cache_key(tuple(parameters.items()), reach)
    if reach.changes and reach.has_lists:
        raise Changeable("it may change what it keeps")
    if is_fixed and isinstance(rhs, types.FunctionType):
        reach.key = of_rhs
        if parameters and reach.is_fixed:
            reach.parameters = tuple(parameters), tuple(parameters.values()), key
        if len(_last) >= MOST:
            _last.clear()
        _last[rhs] = reach
    return key


@lru_cache(maxsize=256)
def cache_slot(key: Hashable) -> list[Captured]:
    """Return the list in which results for a key are cached; empty at first."""
    return []


def _number(value: Captured, _: Captured) -> Hashable:
    return (type(value), value) if value else (type(value), repr(value))  # 0.0 == -0.0, so their text is compared


def _sequence(value: Captured, reach: Reach) -> Hashable:
    if type(value) is list:
        reach.has_lists, reach.is_fixed = True, False
    if len(value) > LONGEST:
        raise Changeable(f"{len(value)} items")
    return type(value), *[cache_key(item, reach) for item in value]


def _mapping(value: dict[Captured, Captured], reach: Reach) -> Hashable:
    reach.has_lists, reach.is_fixed = True, False
    return dict, _sequence(tuple(value), reach), _sequence(tuple(value.values()), reach)


def _array(value: Captured, reach: Reach) -> Hashable:
    reach.has_lists, reach.is_fixed = True, False
    if value.size > LONGEST or value.dtype.hasobject:
        raise Changeable("an array that is large, or of objects")
    return value.shape, value.dtype.str, value.tobytes()


def _module(value: types.ModuleType, _: Captured) -> Hashable:
    if value.__name__.partition(".")[0] not in CONSTANT:
        raise Changeable(f"what stands in the module {value.__name__}")
    return value


def _library_function(value: Captured, _: Captured) -> Hashable:
    name: str = value.__name__
    for module, known in ((math, MATH), (np, ARRAY_FUNCTIONS)):
        if name in known and getattr(module, name, None) is value:
            return module.__name__, name
    raise Changeable(f"{name} is not among the functions that are known")


def _partial(value: Captured, reach: Reach) -> Hashable:
    parts = (value.func, value.args, value.keywords)
    return functools.partial, *[cache_key(part, reach) for part in parts]


def _function(value: types.FunctionType, reach: Reach) -> Hashable:
    if id(value) in reach.numbers:
        return "again", reach.numbers[id(value)]
    reach.numbers[id(value)], module = len(reach.numbers), value.__module__ or ""
    if module == "numpy" or module.startswith("numpy."):
        return _library_function(value, reach)
    if module in TRUSTED:
        return id(value)
    names, changes, reason = _looked_up(value.__code__)
    if reason:
        raise Changeable(f"{value.__name__} {reason}")
    reach.functions.append((value, value.__code__, value.__defaults__))
    values = [value.__defaults__, value.__kwdefaults__]
    for cell in value.__closure__ or ():
        try:
            values.append(cell.cell_contents)
        except ValueError:
            raise Changeable(f"{value.__name__} uses a name that has no value yet") from None
        reach.cells.append((cell, values[-1]))
    for name in names:
        reach.names.append((value.__globals__, name, value.__globals__.get(name, Reach)))
        if name in value.__globals__:
            values.append(value.__globals__[name])
        elif name not in PURE_BUILTINS:
            raise Changeable(f"{value.__name__} uses {name}")
    reach.changes = reach.changes or changes
    return value.__code__, *[cache_key(item, reach) for item in values]


@lru_cache(maxsize=1024)
def _looked_up(code: types.CodeType) -> tuple[tuple[str, ...], bool, str]:
    """Return the global names in a code object, whether it modifies objects, and why it has no key (else empty)."""
    names, changes = set[str](), False
    for part in _parts(code):
        before, catching = None, False
        for line in _instructions(part):
            name = str(line.argval)
            if line.opname in FORBIDDEN or (line.opname == "STORE_DEREF" and name in part.co_freevars):
                return (), False, f"has an instruction {line.opname}"
            if catching and not (line.opname in ("BUILD_TUPLE", "CHECK_EXC_MATCH") or name in CAUGHT):
                return (), False, "catches errors"
            catching = line.opname == "PUSH_EXC_INFO" or (catching and line.opname != "CHECK_EXC_MATCH")
            if line.opname == "IS_OP" and not (before and before.opname == "LOAD_CONST" and before.argval is None):
                return (), False, "compares identities"
            if line.opname == "LOAD_GLOBAL":
                names.add(name)
            elif line.opname in ("LOAD_ATTR", "LOAD_METHOD"):
                if name not in ATTRIBUTES:
                    return (), False, f"uses {name}"
                changes = changes or name in CHANGING
            in_place = line.opname == "BINARY_OP" and line.argrepr.endswith("=")
            changes = changes or in_place or line.opname in ("STORE_SUBSCR", "DELETE_SUBSCR", "STORE_SLICE")
            before = line
    return tuple(sorted(names)), changes, ""


@lru_cache(maxsize=1024)
def global_names(code: types.CodeType) -> set[str]:
    """Return the names that a code object, or one nested in it, looks up as globals; without attributes."""
    lines = (line for part in _parts(code) for line in _instructions(part))
    return {line.argval for line in lines if line.opname in ("LOAD_GLOBAL", "LOAD_NAME")}


@lru_cache(maxsize=64)
def _instructions(code: types.CodeType) -> list[dis.Instruction]:
    """Return the instructions of a code object; cached, because both the key and the trace need them."""
    return [*dis.get_instructions(code)]


def _parts(code: types.CodeType) -> Iterable[types.CodeType]:
    yield code
    for constant in code.co_consts:
        if isinstance(constant, types.CodeType):
            yield from _parts(constant)


_last: dict[types.FunctionType, Reach] = {}  # for the last call of each right-hand side
MOST = 64  # entries of `_last`
READERS: dict[type, Callable[[Captured, Reach], Hashable]] = {
    **dict.fromkeys((float, int, bool, complex, str, bytes), _number),
    type(None): lambda value, _: value,
    **dict.fromkeys((tuple, list), _sequence),
    dict: _mapping,
    np.ndarray: _array,
    **dict.fromkeys((np.ufunc, type(np.dot), types.BuiltinFunctionType), _library_function),
    types.ModuleType: _module,
    types.FunctionType: _function,
    functools.partial: _partial,
}
