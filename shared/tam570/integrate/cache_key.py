"""All that a function's result can depend on, as one hashable value: two of a kind compute the same.

Code, defaults, what closures and globals hold, and so for every function that is called. What may change unseen has no
fingerprint: objects with attributes, modules other than math and NumPy, functions that import or look up names anew.
"""

import dis
import functools
import types
from collections.abc import Callable, Hashable, Iterable
from functools import lru_cache
from typing import Any

import numpy as np

__all__ = ["Changeable", "cache_key", "global_names"]

LONGEST = 1000  # numbers in a list or an array: more take longer to look at than to trace
CONSTANT = ("math", "cmath", "numpy")  # modules
REACHING = {"globals", "locals", "vars", "eval", "exec", "open", "input", "getattr", "random"}


class Changeable(Exception):
    """The function depends on something that may change unseen."""


class Absent:
    """What a name that is looked up stands for, where nothing has it."""


ABSENT = Absent()


def cache_key(value: Any, functions: dict[int, int] | None = None) -> Hashable:
    """Equal for what computes the same. functions : those seen on the way, a function may call itself."""
    read = READERS.get(type(value))
    if read:
        return read(value, {} if functions is None else functions)
    if isinstance(value, np.generic):
        return type(value), value.tobytes()
    if isinstance(value, type) and value.__module__ in ("builtins", "numpy"):
        return value
    raise Changeable(f"{type(value).__name__} may change unseen")


def _number(value: Any, _: Any) -> Hashable:
    return (type(value), value) if value else (type(value), repr(value))  # 0.0 equals -0.0


def _itself(value: Any, _: Any) -> Hashable:
    return value  # type: ignore[no-any-return]


def _sequence(value: Any, functions: dict[int, int]) -> Hashable:
    if len(value) > LONGEST:
        raise Changeable(f"{len(value)} items")
    return type(value), *[cache_key(item, functions) for item in value]


def _mapping(value: dict[Any, Any], functions: dict[int, int]) -> Hashable:
    return dict, _sequence(tuple(value), functions), _sequence(tuple(value.values()), functions)


def _array(value: Any, _: Any) -> Hashable:
    if value.size > LONGEST or value.dtype.hasobject:
        raise Changeable("an array that is large, or of objects")
    return value.shape, value.dtype.str, value.tobytes()


def _module(value: types.ModuleType, _: Any) -> Hashable:
    if value.__name__.partition(".")[0] not in CONSTANT:
        raise Changeable(f"what stands in the module {value.__name__}")
    return value


def _builtin(value: types.BuiltinFunctionType, _: Any) -> Hashable:
    if not (value.__self__ is None or isinstance(value.__self__, types.ModuleType)):
        raise Changeable(f"{value.__name__} of an object")
    return value


def _partial(value: Any, functions: dict[int, int]) -> Hashable:
    parts = (value.func, value.args, value.keywords)
    return functools.partial, *[cache_key(part, functions) for part in parts]


def _function(value: types.FunctionType, functions: dict[int, int]) -> Hashable:
    if id(value) in functions:
        return "again", functions[id(value)]
    functions[id(value)], module = len(functions), value.__module__ or ""
    if module == "numpy" or module.startswith("numpy."):
        return value
    names, hidden = _looked_up(value.__code__)
    if hidden:
        raise Changeable(f"{value.__name__} uses {hidden}")
    held = [value.__defaults__, value.__kwdefaults__]
    if value.__closure__:
        held += [cell.cell_contents for cell in value.__closure__]
    if names:
        known = value.__globals__
        held += [known.get(name, ABSENT) for name in names]
    return value.__code__, *[cache_key(item, functions) for item in held]


@lru_cache(maxsize=1024)
def _looked_up(code: types.CodeType) -> tuple[tuple[str, ...], str]:
    """The names that a code looks up, and those by which it may reach what they do not tell."""
    names = sorted(global_names(code))
    imports = any(line.opname == "IMPORT_NAME" for part in _parts(code) for line in dis.get_instructions(part))
    return tuple(names), ", ".join(sorted(REACHING & set(names)) + ["import"] * imports)


def global_names(code: types.CodeType) -> set[str]:
    """Names that a code, or one inside it, looks up outside of its function; names of attributes among them."""
    return {name for part in _parts(code) for name in part.co_names}


def _parts(code: types.CodeType) -> Iterable[types.CodeType]:
    yield code
    for constant in code.co_consts:
        if isinstance(constant, types.CodeType):
            yield from _parts(constant)


READERS: dict[type, Callable[[Any, dict[int, int]], Hashable]] = {
    **dict.fromkeys((float, int, bool, complex, str, bytes), _number),
    type(None): _itself,
    Absent: _itself,
    **dict.fromkeys((tuple, list), _sequence),
    dict: _mapping,
    np.ndarray: _array,
    np.ufunc: _itself,
    types.ModuleType: _module,
    types.BuiltinFunctionType: _builtin,
    types.FunctionType: _function,
    functools.partial: _partial,
}
