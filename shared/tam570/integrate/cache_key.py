"""All that a function's result can depend on, as one hashable value: two of a kind compute the same.

Code, defaults, what closures and globals hold, and so for every function that is called. Only a function that is seen
to be one of numbers alone has a key, and only that is traced: it compares no types, catches no errors, keeps nothing
from call to call, and uses no names but those listed here. Any other is called as it stands, with arrays.
"""

import dis
import functools
import math
import types
from collections.abc import Callable, Hashable, Iterable
from functools import lru_cache
from typing import Any, TypeAlias

import numpy as np

from tam570.values import Function, Parameters

__all__ = ["Changeable", "cache_key", "call_key", "global_names"]

Captured: TypeAlias = Any  # whatever a right-hand side refers to

LONGEST = 1000  # numbers in a list or an array: more take longer to look at than to trace
CONSTANT = ("math", "numpy")  # modules
TRUSTED = ("tam570.given",)  # ours, whose functions look at parameters and refuse


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
CHANGING = _words("append extend insert fill")  # methods, as setting an item: of what is made inside
ATTRIBUTES = MATH | ARRAY_FUNCTIONS | METHODS | CHANGING
CAUGHT = _words("ValueError ArithmeticError ZeroDivisionError OverflowError")  # errors that no unknown number raises
FORBIDDEN = _words(
    """STORE_GLOBAL DELETE_GLOBAL STORE_ATTR DELETE_ATTR IMPORT_NAME IMPORT_FROM LOAD_NAME STORE_NAME BEFORE_WITH
    WITH_EXCEPT_START LOAD_SPECIAL LOAD_BUILD_CLASS MATCH_CLASS LOAD_SUPER_ATTR GET_AWAITABLE"""
)  # instructions


class Changeable(Exception):
    """The function depends on something that may change unseen."""


def cache_key(value: Captured, functions: dict[int, int] | None = None) -> Hashable:
    """Equal for what computes the same. Raises `Changeable`. functions : those seen on the way; one may call itself."""
    read = READERS.get(type(value))
    if read:
        return read(value, {} if functions is None else functions)
    if isinstance(value, np.generic):
        return type(value), value.tobytes()
    if isinstance(value, type) and value.__module__ in ("builtins", "numpy"):
        return value
    raise Changeable(f"{type(value).__name__} may change unseen")


def call_key(rhs: Function, parameters: Parameters | None) -> Hashable:
    """Return the key of a right-hand side with its parameters. Raises `Changeable`."""
    functions: dict[int, int] = {}
    key = cache_key(rhs, functions)
    if parameters:
        key = key, cache_key(tuple(parameters.items()), functions)
    if CHANGES in functions and MUTABLE in functions:
        raise Changeable("it may change what it keeps")
    return key


def _number(value: Captured, _: Captured) -> Hashable:
    return (type(value), value) if value else (type(value), repr(value))  # 0.0 equals -0.0


def _itself(value: Captured, _: Captured) -> Hashable:
    return value  # type: ignore[no-any-return]


def _sequence(value: Captured, functions: dict[int, int]) -> Hashable:
    if type(value) is list:
        functions[MUTABLE] = 0
    if len(value) > LONGEST:
        raise Changeable(f"{len(value)} items")
    return type(value), *[cache_key(item, functions) for item in value]


def _mapping(value: dict[Captured, Captured], functions: dict[int, int]) -> Hashable:
    functions[MUTABLE] = 0
    return dict, _sequence(tuple(value), functions), _sequence(tuple(value.values()), functions)


def _array(value: Captured, functions: dict[int, int]) -> Hashable:
    functions[MUTABLE] = 0
    if value.size > LONGEST or value.dtype.hasobject:
        raise Changeable("an array that is large, or of objects")
    return value.shape, value.dtype.str, value.tobytes()


def _module(value: types.ModuleType, _: Captured) -> Hashable:
    if value.__name__.partition(".")[0] not in CONSTANT:
        raise Changeable(f"what stands in the module {value.__name__}")
    return value


def _builtin(value: types.BuiltinFunctionType, _: Captured) -> Hashable:
    name: str = value.__name__
    if getattr(math, name, None) is not value:
        raise Changeable(f"{name} is not among the functions that are known")
    return "math", name


def _numpy_function(value: Captured, _: Captured) -> Hashable:
    name: str = value.__name__
    if name not in ARRAY_FUNCTIONS or getattr(np, name, None) is not value:
        raise Changeable(f"{name} is not among the functions that are known")
    return "numpy", name


def _partial(value: Captured, functions: dict[int, int]) -> Hashable:
    parts = (value.func, value.args, value.keywords)
    return functools.partial, *[cache_key(part, functions) for part in parts]


def _function(value: types.FunctionType, functions: dict[int, int]) -> Hashable:
    if id(value) in functions:
        return "again", functions[id(value)]
    functions[id(value)], module = len(functions), value.__module__ or ""
    if module == "numpy" or module.startswith("numpy."):
        return _numpy_function(value, functions)
    if module in TRUSTED:
        return id(value)
    names, changes, reason = _looked_up(value.__code__)
    if reason:
        raise Changeable(f"{value.__name__} {reason}")
    values = [value.__defaults__, value.__kwdefaults__]
    for cell in value.__closure__ or ():
        try:
            values.append(cell.cell_contents)
        except ValueError:
            raise Changeable(f"{value.__name__} uses a name that has no value yet") from None
    for name in names:
        if name in value.__globals__:
            values.append(value.__globals__[name])
        elif name not in PURE_BUILTINS:
            raise Changeable(f"{value.__name__} uses {name}")
    if changes:
        functions[CHANGES] = 0
    return value.__code__, *[cache_key(item, functions) for item in values]


@lru_cache(maxsize=1024)
def _looked_up(code: types.CodeType) -> tuple[tuple[str, ...], bool, str]:
    """Return the global names of a code, whether it changes arrays or lists, and why it is not one of numbers alone."""
    names, changes = set[str](), False
    for part in _parts(code):
        before, catching = None, False
        for line in dis.get_instructions(part):
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


def global_names(code: types.CodeType) -> set[str]:
    """Names that a code, or one inside it, looks up outside of its function; names of attributes among them."""
    return {name for part in _parts(code) for name in part.co_names}


def _parts(code: types.CodeType) -> Iterable[types.CodeType]:
    yield code
    for constant in code.co_consts:
        if isinstance(constant, types.CodeType):
            yield from _parts(constant)


MUTABLE, CHANGES = -1, -2  # among `functions`: a list or an array is in reach; something sets items
READERS: dict[type, Callable[[Captured, dict[int, int]], Hashable]] = {
    **dict.fromkeys((float, int, bool, complex, str, bytes), _number),
    type(None): _itself,
    **dict.fromkeys((tuple, list), _sequence),
    dict: _mapping,
    np.ndarray: _array,
    np.ufunc: _numpy_function,
    type(np.dot): _numpy_function,
    types.ModuleType: _module,
    types.BuiltinFunctionType: _builtin,
    types.FunctionType: _function,
    functools.partial: _partial,
}
