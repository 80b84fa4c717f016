"""Records the quantities by which a called right-hand side decides, and evaluates them at many points.

A `Course` is a tape whose symbols have values at several points of a step. The function decides as at the first point,
and the tape records the quantities behind its decisions, the switching functions: the difference of two numbers that
are compared, the distance of a rounded number from the next integer, or from the next entry of a table. Where one
crosses zero, the function may change its formulas. Until then only the operations that lead to them are repeated.
"""

import copy
import functools
import inspect
import math
import operator
import sysconfig
import types
from collections.abc import Callable, Sequence
from numbers import Complex

import numpy as np

from tam570.integrate.arguments import Array
from tam570.integrate.trace import EDGES, NUMPY_NAMES, OPERATORS, Module, Symbol, Tape, substituted
from tam570.values import Function, Numbers

FOREIGN = tuple(sysconfig.get_paths()[name] for name in ("stdlib", "platstdlib", "purelib", "platlib"))
OURS = "tam570"
FILLED = {"zeros", "ones", "empty", "full", "zeros_like", "ones_like", "empty_like", "full_like"}
IN_PAIRS = {"modf", "divmod"}  # functions that return two numbers
SATURATING = {"exp", "exp2", "expm1", "tanh", "erf", "erfc", "sinh", "cosh", "expit"}
BY_BITS = {"spacing", "nextafter", "ulp", "arange"}  # functions with jumps at points that no value reveals
INSIDE = 1e-9  # of the first interval, the point at which numbers are rounded
LARGEST_TABLE = 100_000  # entries


class Course(Tape):
    """A tape with values at several points of a step, which records the switching functions.

    slots      : the values of operations and constants, at m points or constant; the first are t and y
    operations : slot of the result, function and slots of its operands
    seen       : slots of the switching functions; saturating : slots of arguments of exp, tanh and the like
    opaque     : a called function that cannot be analyzed and may jump between the points; empty if none
    denominators : slots of denominators, whose zeros are poles; lines : slots that are affine in time alone
    is_line    : whether each of `seen` is in `lines`
    """

    def __init__(self, t: Array, y: Array) -> None:
        self.slots: list[Numbers] = [t, *y]
        self.operations: list[tuple[int, Function, tuple[int, ...]]] = []
        self.seen: list[int] = []
        self.saturating: list[int] = []
        self.denominators: list[int] = []
        self.lines = {0}
        self.opaque = ""

    def values(self, x: Symbol) -> Numbers:
        return self.slots[x.number]

    def is_complex(self, x: Symbol) -> bool:
        return np.iscomplexobj(self.values(x))

    def slot_of(self, value: Numbers) -> int:
        if isinstance(value, Symbol):
            if value.tape is not self:
                raise RuntimeError("it uses what it kept of an earlier call")
            return value.number
        self.slots.append(value if np.iscomplexobj(value) else float(value))
        return len(self.slots) - 1

    def record(self, function: Numbers, *operands: Numbers) -> Symbol:
        """Record the result of a function, or of the operator with this name, on symbols and numbers at all points."""
        function, numbers = OPERATORS.get(function, function), tuple(map(self.slot_of, operands))
        self.slots.append(function(*(self.slots[i] for i in numbers)))
        self.operations.append((len(self.slots) - 1, function, numbers))
        return Symbol(self, len(self.slots) - 1, "", ())

    def combine(self, name: str, *operands: Numbers) -> Numbers:
        first, last = operands[0], operands[-1]
        if name == "fabs" and not self.is_complex(first):
            return -first if self.sign(first) < 0 else first
        result = self.record(np.abs if name == "fabs" else name, *operands)
        if name == "/" and isinstance(last, Symbol) and not self.is_complex(last):
            self.denominators.append(last.number)
        x, *others = [a for a in operands if isinstance(a, Symbol)]
        if x.number in self.lines and not others and name != "pow" and not self.is_complex(result):
            self.lines.add(result.number)
            self.seen += [result.number] if name in "+-" else []
        return result

    def method(self, name: str) -> Function:
        if name in ("item", "tolist"):
            return lambda x: x
        function: Function | None = None if name.startswith("_") else getattr(np, name, None)
        if not callable(function):
            raise AttributeError(name)
        return _lifted(function)

    def sign(self, x: Symbol) -> float:
        """Record x as a switching function; return the sign of its first nonzero value. TypeError if x is complex."""
        if self.is_complex(x):
            raise TypeError("complex numbers have no order")
        self.seen += [] if x.number in self.seen else [x.number]
        first = self.values(x)[0] or next((v for v in self.values(x) if v), 0.0)
        return math.copysign(1.0, first) if first else 0.0

    def rounded(self, x: Symbol, half: float = 0.0) -> float:
        """Return x rounded down, or to the nearest integer with half = 0.5; record where the result changes."""
        moved = self.record("+", x, half)
        self.lines |= {moved.number} if x.number in self.lines else set()
        low = float(math.floor(self.soon(moved)))
        self.note_levels(moved, low, low + 1)
        return low

    def soon(self, x: Symbol) -> float:
        """Return the value just after the first point, as x may be an integer there."""
        first, second, *_ = values = self.values(x)
        soon = first + INSIDE * (second - first)
        return float(soon if soon != first else np.nextafter(first, values[np.argmax(values != first)]))

    def note_levels(self, x: Symbol, *levels: float) -> None:
        for part in [self.record(p, x) for p in (np.real, np.imag)] if self.is_complex(x) else [x]:
            distances = [self.record("-", part, level).number for level in levels]
            self.seen += distances
            self.lines |= {*distances} if x.number in self.lines else set()

    def note_table(self, x: Symbol, table: Sequence[float]) -> None:
        """Record the distances from the neighboring entries of a table."""
        position = int(np.searchsorted(table, self.soon(x)))
        self.note_levels(x, *table[max(position - 1, 0) : position + 1])

    def forget_results(self) -> None:
        """Drop operations that no switching function needs; poles count if there are other switching functions."""
        self.seen += self.denominators if self.seen else []
        self.is_line = np.array([slot in self.lines for slot in self.seen], dtype=bool)
        needed = {*self.seen, *self.saturating}
        for slot, _, operands in reversed(self.operations):
            needed.update(operands if slot in needed else ())
        self.operations = [operation for operation in self.operations if operation[0] in needed]

    def evaluate(self, t: Array, y: Array) -> tuple[list[Array], list[Array]]:
        """Return switching functions and saturating arguments at other points, valid while decisions are the same."""
        slots = self.slots
        slots[: len(y) + 1] = t, *y
        for slot, function, operands in self.operations:
            slots[slot] = function(*[slots[i] for i in operands])
        return [slots[i] for i in self.seen], [slots[i] for i in self.saturating]


def _sign(x: Numbers) -> float:
    return float(x.tape.sign(x) if isinstance(x, Symbol) else np.sign(x))


def _holds(test: Function, x: Numbers) -> bool:
    """Return whether the test is true for x at the first point; record where that changes."""
    if not isinstance(x, Symbol):
        return bool(test(x))
    course: Numbers = x.tape
    return float(course.sign(course.record(lambda values: np.where(test(values), 1.0, -1.0), x))) > 0


def _recorded(part: Function, x: Numbers) -> Numbers:
    """Return a part of a complex number or symbol."""
    if not isinstance(x, Symbol):
        return part(x)
    course: Numbers = x.tape
    course.note_levels(x, *[0.0] * (part is np.angle))  # branch cut
    return course.record(part, x)


def _clip(x: Numbers, a_min: Numbers = None, a_max: Numbers = None, **limits: Numbers) -> Numbers:
    """Return numpy.clip of a number or symbol; limits : min and max, other names of a_min and a_max."""
    low, high = limits.get("min", a_min), limits.get("max", a_max)
    x = x if low is None else max(x, low)
    return x if high is None else min(x, high)


# Functions that decide, and parts of complex numbers, by their name in math or NumPy.
DECIDING: dict[str, Function] = {
    "sign": lambda x: _sign(x),
    "copysign": lambda x, y: abs(x) * (_sign(y) or 1.0),
    "heaviside": lambda x, at_zero: {-1.0: 0.0, 0.0: at_zero, 1.0: 1.0}[_sign(x)],
    **dict.fromkeys(("fabs", "absolute", "abs"), abs),
    **dict.fromkeys(("maximum", "fmax"), max),
    **dict.fromkeys(("minimum", "fmin"), min),
    "clip": _clip,
    "modf": lambda x: (x - math.trunc(x), 1.0 * math.trunc(x)),
    "divmod": divmod,
    "floor": math.floor,
    "ceil": math.ceil,
    **dict.fromkeys(("trunc", "fix"), math.trunc),
    **dict.fromkeys(("rint", "round"), round),
    **dict.fromkeys(("remainder", "mod"), operator.mod),
    "floor_divide": operator.floordiv,
    "fmod": lambda a, b: a % b if a >= 0 else -(-a % b),
    "isclose": lambda a, b, rtol=1e-5, atol=1e-8: bool(abs(a - b) <= atol + rtol * abs(b)),
    "math.isclose": lambda a, b, rel_tol=1e-9, abs_tol=0.0: bool(
        abs(a - b) <= max(rel_tol * max(abs(a), abs(b)), abs_tol)
    ),
    "math.remainder": lambda x, period: x - round(x / period) * period,
    **{test.__name__: functools.partial(_holds, test) for test in (np.isfinite, np.isnan, np.isinf)},
    "nan_to_num": lambda x: 0.0 if _holds(np.isnan, x) else x,
    **{"less": operator.lt, "less_equal": operator.le, "greater": operator.gt, "greater_equal": operator.ge},
    **{"equal": operator.eq, "not_equal": operator.ne, "signbit": lambda x: _sign(x) < 0},
    **{part.__name__: functools.partial(_recorded, part) for part in (np.real, np.imag, np.angle)},
    "phase": functools.partial(_recorded, np.angle),
}


class Components(np.ndarray[tuple[int, ...], np.dtype[np.object_]]):
    """An array of symbols with the parts of complex numbers and the conversions that an array of objects lacks."""

    @property
    def real(self) -> Numbers:
        return self._by_component("real")

    @real.setter
    def real(self, value: Numbers) -> None:
        self[...] = value + 1j * self.imag

    @property
    def imag(self) -> Numbers:
        return self._by_component("imag")

    @imag.setter
    def imag(self, value: Numbers) -> None:
        self[...] = self.real + 1j * value

    def _by_component(self, name: str) -> Numbers:
        """Return the parts, read-only because they are copies."""
        parts = np.frompyfunc(DECIDING[name], 1, 1)(self)
        parts.flags.writeable = False
        return parts

    def astype(self, dtype: Numbers, **_: Numbers) -> Numbers:  # type: ignore[override]
        return self.copy() if _is_number_type(dtype) else super().astype(dtype)

    def view(self, dtype: Numbers) -> Numbers:  # type: ignore[override]
        if not _is_number_type(dtype):
            return super().view(dtype)
        if _plain_type(dtype) is complex:
            view = self[..., 0::2] + 1j * self[..., 1::2]
        else:
            view = np.stack([self.real, self.imag], axis=-1).reshape(*self.shape[:-1], -1)
        view.flags.writeable = False
        return view


def _parts(value: Numbers) -> Numbers:
    """Yield the symbols in an argument."""
    if isinstance(value, Symbol):
        yield value
    elif isinstance(value, np.ndarray) and value.dtype == object:
        yield from (part for part in value.ravel().tolist() if isinstance(part, Symbol))
    elif type(value) in (list, tuple):
        for part in value:
            yield from _parts(part)


def _replaced(value: Numbers, replace: Function) -> Numbers:
    """Return a copy of an argument with replace(symbol) for each symbol."""
    if isinstance(value, Symbol):
        return replace(value)
    if type(value) in (list, tuple):
        return type(value)(_replaced(part, replace) for part in value)
    if isinstance(value, np.ndarray) and value.dtype == object:
        parts = [replace(part) if isinstance(part, Symbol) else part for part in value.ravel().tolist()]
        keeps_symbols = any(isinstance(part, Symbol) for part in parts)
        return np.array(parts, dtype=object if keeps_symbols else None).reshape(value.shape)
    return value.copy() if isinstance(value, np.ndarray) else value


def _lifted(function: Function) -> Function:
    """Return a function of numbers and arrays as one that also accepts symbols and arrays of symbols."""
    name = getattr(function, "__name__", "")
    name = f"math.{name}" if function in (math.isclose, math.remainder) else name

    @functools.wraps(function, updated=())
    def lifted(*arguments: Numbers, **keywords: Numbers) -> Numbers:
        if getattr(function, "__module__", "") == "cmath":
            arguments = tuple(a + 0j if isinstance(a, Symbol) else a for a in arguments)
        symbols = [*_parts(arguments), *_parts(tuple(keywords.values()))]
        if not symbols:
            result = function(*map(_plain_type, arguments), **{k: _plain_type(a) for k, a in keywords.items()})
            return result.astype(object).view(Components) if name in FILLED and result.dtype.kind in "fc" else result
        tape: Course = symbols[0].tape
        arguments = tuple(a for a in arguments if not _is_number_type(a))  # symbols have no such type
        keywords = {key: a for key, a in keywords.items() if not _is_number_type(a)}
        scalars = all(isinstance(a, Symbol | Complex) for a in arguments)
        if name in SATURATING:
            tape.saturating += [_recorded(np.real, s).number if tape.is_complex(s) else s.number for s in symbols]
        tape.opaque = name if name in BY_BITS else tape.opaque
        if name in DECIDING:
            decide = functools.partial(DECIDING[name], **keywords)
            by_component = np.frompyfunc(decide, len(arguments), 1 + (name in IN_PAIRS))
            return decide(*arguments) if scalars else by_component(*arguments)
        smooth = getattr(np, NUMPY_NAMES.get(name, name), None)
        if scalars and not keywords and isinstance(smooth, np.ufunc) and smooth.nout == 1:
            tape.note_levels(symbols[0], *EDGES.get(name, ()))
            if name == "tan":
                tape.denominators.append(tape.record(np.cos, *arguments).number)
            return tape.record(smooth, *arguments)
        if not scalars and getattr(function, "__module__", "") == "numpy" or isinstance(function, np.ufunc):
            try:
                result = function(*arguments, **keywords)
                return result.view(Components) if type(result) is np.ndarray and result.dtype == object else result
            except (TypeError, ValueError, AttributeError):
                pass
        return _joined(tape, _point_by_point(tape, function, symbols, arguments, keywords))

    if isinstance(function, np.ufunc):  # these compare or add the symbols in an array
        vars(lifted).update(reduce=function.reduce, accumulate=function.accumulate, outer=function.outer)
    return lifted


def _point_by_point(
    tape: Course, function: Function, symbols: list[Symbol], arguments: Numbers, keywords: Numbers
) -> Symbol:
    """Record calls, point by point, of a function that cannot be traced; record where symbols cross table entries."""
    tables = [*filter(_is_table, arguments), *_tables_of(function)]
    package = (getattr(function, "__module__", "") or "").partition(".")[0]
    before, tape.opaque = tape.opaque, getattr(function, "__name__", type(function).__name__)  # it may raise
    for table in tables:
        for symbol in symbols:
            tape.note_table(symbol, table)
    call = _replaced((arguments, tuple(keywords.values())), lambda symbol: symbol)  # as the function may change them

    def results(*values: Array) -> list[Numbers]:
        columns = {symbol.number: v.tolist() for symbol, v in zip(symbols, values, strict=True)}
        calls = [_replaced(call, lambda symbol, k=k: columns[symbol.number][k]) for k in range(len(values[0]))]
        return [function(*positional, **dict(zip(keywords, by_name, strict=True))) for positional, by_name in calls]

    recorded = tape.record(results, *symbols)
    if tables or isinstance(function, np.ufunc) or package in ("math", "numpy"):
        tape.opaque = before
    return recorded


def _joined(tape: Course, results: Symbol) -> Numbers:
    """Return results at all points as symbols; integers and bools are decisions."""
    first = tape.values(results)[0]
    if isinstance(first, tuple | list):
        parts = (tape.record(lambda r, i=i: [part[i] for part in r], results) for i in range(len(first)))
        return type(first)(_joined(tape, part) for part in parts)
    array = np.asarray(first)
    if array.dtype.kind in "biu" and array.ndim == 0:
        tape.sign(tape.record(lambda r: np.where(np.array(r) == first, 1.0, -1.0), results))
        return first
    joined = np.empty(array.size, dtype=object)
    for i in range(array.size):
        joined[i] = tape.record(lambda r, i=i: np.array([np.ravel(a)[i] for a in r]) + 0.0, results)
    return joined.reshape(array.shape) if array.ndim else joined[0]


def _is_table(value: Numbers) -> bool:
    """Return whether a value is a sequence of numbers that does not decrease."""
    if not isinstance(value, list | tuple | np.ndarray):
        return False
    try:
        table = np.asarray(value, dtype=float)
    except (TypeError, ValueError):
        return False
    return table.ndim == 1 and 1 < table.size <= LARGEST_TABLE and bool((np.diff(table) >= 0).all())


def _tables_of(function: Function) -> list[Numbers]:
    """Return the tables in attributes of an object, such as an interpolant of SciPy."""
    if isinstance(function, types.FunctionType | types.BuiltinFunctionType | np.ufunc | type):
        return []
    members = [getattr(function, name, None) for name in dir(function) if name[0] != "_"]
    tables = [table for member in members for table in (member if isinstance(member, tuple) else (member,))]
    return [table for table in tables if isinstance(table, np.ndarray) and _is_table(table)]


def _substitute(value: Numbers) -> Numbers:
    """Return the replacement of a value in a function of symbols; the value itself if it is to be traced."""
    if isinstance(value, types.ModuleType):
        return Module(value, lambda used: substituted(used, _substitute, STAND_INS))
    if isinstance(value, types.BuiltinFunctionType):
        return value if value.__module__ in ("builtins", "_functools", "_operator") else _lifted(value)
    if isinstance(value, types.FunctionType):
        return _lifted(value) if _is_foreign(value) else value
    if isinstance(value, functools._lru_cache_wrapper):
        return substituted(value.__wrapped__, _substitute, STAND_INS)
    if isinstance(value, np.vectorize):
        by_component = substituted(value.pyfunc, _substitute, STAND_INS)
        return lambda *arguments: np.frompyfunc(by_component, len(arguments), 1)(*arguments)
    if isinstance(value, type):
        return TYPES.get(value, value)
    if isinstance(value, functools.partial) or not callable(value):
        return value
    is_method = isinstance(value, types.MethodType)
    function = value.__func__ if is_method else type(value).__call__
    if not _is_looked_into(function):
        return _lifted(value)
    if is_method:
        return types.MethodType(substituted(function, _substitute, STAND_INS), _copied(value.__self__))
    return _copied(value)


def _copied(instance: Numbers) -> Numbers:
    """Return a copy of an instance for symbols, also of its containers, so that methods do not modify the original."""
    if isinstance(instance, type) or not hasattr(instance, "__dict__"):
        return instance
    twin = copy.copy(instance)
    for name, value in vars(instance).items():
        twin.__dict__[name] = copy.copy(value) if isinstance(value, list | dict | set) else _substitute(value)
    model = type(instance)
    listed = {name: inspect.getattr_static(model, name) for name in dir(model)}
    methods = {name: _when_called(value) for name, value in listed.items() if _is_looked_into(value)}
    if twin is not instance and methods:
        object.__setattr__(twin, "__class__", type(model.__name__, (model,), methods))
    return twin


def _when_called(method: types.FunctionType) -> Function:
    """Return a method for symbols, substituted when first called, as it may refer to its instance by name."""
    substitute = functools.cache(lambda: substituted(method, _substitute, STAND_INS))
    return lambda *arguments, **keywords: substitute()(*arguments, **keywords)


def _is_looked_into(value: Numbers) -> bool:
    return isinstance(value, types.FunctionType) and not _is_foreign(value)


def _is_foreign(function: types.FunctionType) -> bool:
    module = function.__module__ or ""
    return module.partition(".")[0] != OURS and function.__code__.co_filename.startswith(FOREIGN)


class _Type(type):
    """Metaclass of the stand-ins for number types; plain : the type that is replaced."""

    plain: type

    def __instancecheck__(cls, value: Numbers) -> bool:
        return _isinstance(value, cls.plain)


class _Float(metaclass=_Type):
    plain = float

    def __new__(cls, value: Numbers = 0.0) -> Numbers:
        if isinstance(value, np.ndarray) and value.shape == () and value.dtype == object:
            value = value.item()
        return value if isinstance(value, Symbol) else float(value)


class _Complex(metaclass=_Type):
    plain = complex

    def __new__(cls, *parts: Numbers) -> Numbers:
        if not any(isinstance(part, Symbol) for part in parts):
            return complex(*parts)
        real, imaginary = (*parts, 0.0)[:2]
        return real + 1j * imaginary


def _isinstance(value: Numbers, kinds: Numbers) -> bool:
    if isinstance(value, Symbol):
        course: Numbers = value.tape
        value = course.values(value)[0].item()
    return isinstance(value, kinds)


TYPES = {float: _Float, np.float64: _Float, complex: _Complex, np.complex128: _Complex}
STAND_INS = {"float": _Float, "complex": _Complex, "isinstance": _isinstance}


def _is_number_type(value: Numbers) -> bool:
    return isinstance(value, _Type) or isinstance(value, type) and value in TYPES


def _plain_type(value: Numbers) -> Numbers:
    return value.plain if isinstance(value, _Type) else value


def along(rates: Function, size: int) -> Callable[[Array, Array], Course]:
    """Return profile(t, y), which returns the course of rates(t, y) at (m,) times and (k, m) states."""
    twin = substituted(rates, _substitute, STAND_INS)

    def profile(t: Array, y: Array) -> Course:
        course = Course(t, y)
        time, *components = (Symbol(course, slot, "", ()) for slot in range(1 + size))
        twin(time, np.array(components, dtype=object).view(Components))
        course.forget_results()
        return course

    return profile


def copy_of(rates: Function) -> Function:
    """Return a copy of a function with separate memory: variables, lists and other containers."""
    return substituted(rates, _with_own_memory, {})  # type: ignore[no-any-return]


def _with_own_memory(value: Numbers) -> Numbers:
    """Return a callable object with copies of its containers; functions of other packages are left unchanged."""
    if isinstance(value, types.FunctionType):
        return functools.partial(value) if _is_foreign(value) else value
    if isinstance(value, types.MethodType) and _is_looked_into(value.__func__):
        return types.MethodType(value.__func__, _forgetful(value.__self__))
    return _forgetful(value) if callable(value) and _is_looked_into(type(value).__call__) else value


def _forgetful(instance: Numbers) -> Numbers:
    twin = copy.copy(instance)
    for name, member in {} if isinstance(twin, type) else getattr(twin, "__dict__", {}).items():
        if isinstance(member, list | dict | set | np.ndarray):
            twin.__dict__[name] = copy.copy(member)
    return twin
