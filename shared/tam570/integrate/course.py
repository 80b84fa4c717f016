"""What a right-hand side that is called as it stands decides by, written down once and evaluated at many points.

A `Course` is a number known at several points of a step at once. What a function decides by it, it decides as at the
first point, and what it decides by is noted: the difference of two numbers that are compared, the distance from the
next whole number where one is rounded, from the next entry where one is looked up in a table. Where one of these
passes zero, the function may do something else. Until then the operations that lead to them are all that is repeated.
"""

import copy
import functools
import math
import operator
import sysconfig
import types
from collections.abc import Callable, Sequence
from numbers import Real

import numpy as np

from tam570.integrate.arguments import Array
from tam570.integrate.symbols import NUMPY_NAMES
from tam570.integrate.trace import substituted
from tam570.values import Function, Numbers

__all__ = ["Course", "Decisions", "along"]

FOREIGN = tuple(sysconfig.get_paths()[name] for name in ("stdlib", "platstdlib", "purelib", "platlib"))
OURS = "tam570"
FILLED = {"zeros", "ones", "empty", "full", "zeros_like", "ones_like", "empty_like", "full_like"}
SATURATING = {"exp", "exp2", "expm1", "tanh", "erf", "erfc", "sinh", "cosh", "expit"}
INSIDE = 1e-9  # of the first cell, where what is rounded is decided
LARGEST_TABLE = 100_000


class Decisions:
    """What a function decides by along a step.

    slots      : of each operation and each constant the value, at m points or the same at all
    operations : slot, function and slots of its operands
    seen       : slots of what it decides by; saturating : of the arguments of exp, tanh and their like;
    denominators : of what has a pole where it is zero
    """

    def __init__(self, t: Array, y: Array) -> None:
        self.slots: list[Numbers] = [t, *y]
        self.operations: list[tuple[int, Function, tuple[int, ...]]] = []
        self.seen: list[int] = []
        self.saturating: list[int] = []
        self.denominators: list[int] = []

    def sign(self, course: "Course") -> float:
        """Note a difference; return its sign on the path that the function takes."""
        self.seen.append(course.slot)
        first = course.values[0] or next((v for v in course.values if v), 0.0)
        return math.copysign(1.0, first) if first else 0.0

    def slot_of(self, value: Numbers) -> int:
        if isinstance(value, Course):
            return value.slot
        self.slots.append(float(value))
        return len(self.slots) - 1

    def forget_results(self) -> None:
        """Keep the operations that lead to what is noted; of a function that decides by nothing else no poles."""
        self.seen += self.denominators if self.seen else []
        needed = {*self.seen, *self.saturating}
        for slot, _, operands in reversed(self.operations):
            needed.update(operands if slot in needed else ())
        self.operations = [operation for operation in self.operations if operation[0] in needed]

    def again(self, t: Array, y: Array) -> tuple[list[Array], list[Array]]:
        """Return what was seen, and what saturates, at other points, as far as the function decides the same."""
        slots = self.slots
        slots[: len(y) + 1] = t, *y
        for slot, function, operands in self.operations:
            slots[slot] = function(*[slots[i] for i in operands])
        return [slots[i] for i in self.seen], [slots[i] for i in self.saturating]


def _applied(function: Function, *operands: Numbers, is_line: bool = False) -> "Course":
    """Return what a function makes of courses and numbers, point by point; written down."""
    decisions: Decisions = next(operand.decisions for operand in operands if isinstance(operand, Course))
    numbers = tuple(map(decisions.slot_of, operands))
    decisions.slots.append(function(*(decisions.slots[i] for i in numbers)))
    decisions.operations.append((len(decisions.slots) - 1, function, numbers))
    return Course(decisions, len(decisions.slots) - 1, is_line)


def _arithmetic(function: Function, *, swapped: bool = False, notes: bool = False) -> Numbers:
    def method(self: "Course", other: Numbers) -> Numbers:
        if not isinstance(other, Course | Real):
            return NotImplemented
        is_line = self.is_line and not isinstance(other, Course)
        operands = (other, self) if swapped else (self, other)
        result = _applied(function, *operands, is_line=is_line)
        if function is _quotient and isinstance(operands[1], Course):
            self.decisions.denominators.append(operands[1].slot)
        if notes and is_line:
            self.decisions.seen.append(result.slot)
        return result

    return method


def _comparison(compare: Callable[[Numbers, Numbers], bool]) -> Numbers:
    def method(self: "Course", other: Numbers) -> Numbers:
        if not isinstance(other, Course | Real):
            return NotImplemented
        return compare(self.decisions.sign(_applied(operator.sub, self, other)), 0.0)

    return method


def _quotient(a: Numbers, b: Numbers) -> Numbers:
    return np.true_divide(a, b)


def _refuse(*_: Numbers) -> Numbers:
    raise TypeError("a function wants the digits of a number")


class Course:
    """A number at m points of a step. slot : where it is written down; is_line : whether it is affine in time alone."""

    __slots__ = ("decisions", "is_line", "slot", "values")

    def __init__(self, decisions: Decisions, slot: int, is_line: bool = False) -> None:
        self.decisions, self.slot, self.is_line = decisions, slot, is_line
        self.values = decisions.slots[slot]

    __add__, __radd__ = _arithmetic(operator.add, notes=True), _arithmetic(operator.add, swapped=True, notes=True)
    __sub__, __rsub__ = _arithmetic(operator.sub, notes=True), _arithmetic(operator.sub, swapped=True, notes=True)
    __mul__, __rmul__ = _arithmetic(operator.mul), _arithmetic(operator.mul, swapped=True)
    __truediv__, __rtruediv__ = _arithmetic(_quotient), _arithmetic(_quotient, swapped=True)

    def __pow__(self, other: Numbers) -> Numbers:
        return _applied(np.power, self, other)

    def __rpow__(self, other: Numbers) -> Numbers:
        return _applied(np.power, other, self)

    def __neg__(self) -> "Course":
        return _applied(operator.neg, self, is_line=self.is_line)

    def __pos__(self) -> "Course":
        return self

    def __abs__(self) -> "Course":
        return -self if self.decisions.sign(self) < 0 else self

    __lt__, __le__ = _comparison(operator.lt), _comparison(operator.le)
    __gt__, __ge__ = _comparison(operator.gt), _comparison(operator.ge)
    __eq__, __ne__ = _comparison(operator.eq), _comparison(operator.ne)
    __hash__ = None  # type: ignore[assignment]
    __str__ = __repr__ = __format__ = __reduce_ex__ = _refuse

    def __bool__(self) -> bool:
        return self.decisions.sign(self) != 0.0

    def rounded(self, half: float = 0.0) -> float:
        """Return the whole number below, or the nearest with half = 0.5; note where it changes."""
        course = _applied(operator.add, self, half)
        low = float(math.floor(course.soon()))
        course.note_levels(low, low + 1)
        return low

    def soon(self) -> float:
        """Return it just beyond the start, where it may be whole."""
        return float(self.values[0] + INSIDE * (self.values[1] - self.values[0]))

    def note_levels(self, *levels: float) -> None:
        self.decisions.seen += [_applied(operator.sub, self, level).slot for level in levels]

    def __floor__(self) -> int:
        return int(self.rounded())

    def __ceil__(self) -> int:
        return -int((-self).rounded())

    def __trunc__(self) -> int:
        return self.__floor__() if self.decisions.sign(self) >= 0 else self.__ceil__()

    __int__ = __trunc__

    def __round__(self, digits: Numbers = None) -> Numbers:
        scale = 10.0 ** (digits or 0)
        value = (self * scale).rounded(0.5)
        return int(value) if digits is None else value / scale

    def __floordiv__(self, period: Numbers) -> Numbers:
        return float((self / period).rounded())

    def __mod__(self, period: Numbers) -> Numbers:
        return self - (self / period).rounded() * period

    def __rfloordiv__(self, other: Numbers) -> Numbers:
        return float((other / self).rounded())

    def __rmod__(self, other: Numbers) -> Numbers:
        return other - (other / self).rounded() * self

    def __divmod__(self, period: Numbers) -> Numbers:
        return self // period, self % period

    def __getattr__(self, name: str) -> Numbers:
        """NumPy's functions ask an object for a method of their name."""
        function = getattr(np, name, None)
        if name.startswith("_") or not callable(function):
            raise AttributeError(name)
        return functools.partial(_lifted(function), self)

    def note_table(self, table: Sequence[float]) -> None:
        """Note the distance from the next numbers of a table, above and below."""
        position = int(np.searchsorted(table, self.soon()))
        self.note_levels(*table[max(position - 1, 0) : position + 1])


def _sign(x: Numbers) -> float:
    return float(x.decisions.sign(x) if isinstance(x, Course) else np.sign(x))


def _is_close(a: Numbers, b: Numbers, rtol: Numbers = 1e-5, atol: Numbers = 1e-8) -> bool:
    return bool(abs(a - b) <= atol + rtol * abs(b))


def _is_close_by_math(a: Numbers, b: Numbers, rel_tol: Numbers = 1e-9, abs_tol: Numbers = 0.0) -> bool:
    return bool(abs(a - b) <= max(rel_tol * max(abs(a), abs(b)), abs_tol))


def _fmod(a: Numbers, b: Numbers) -> Numbers:
    return a % b if a >= 0 else -(-a % b)


# Functions that decide, by the name that they have in math or NumPy.
DECIDING: dict[str, Function] = {
    "sign": lambda x: _sign(x),
    "copysign": lambda x, y: abs(x) * (_sign(y) or 1.0),
    "heaviside": lambda x, at_zero: {-1.0: 0.0, 0.0: at_zero, 1.0: 1.0}[_sign(x)],
    "fabs": abs,
    "absolute": abs,
    "abs": abs,
    "maximum": max,
    "fmax": max,
    "minimum": min,
    "fmin": min,
    "clip": lambda x, low, high: min(max(x, low), high),
    "floor": math.floor,
    "ceil": math.ceil,
    "trunc": math.trunc,
    "fix": math.trunc,
    "rint": round,
    "round": round,
    "remainder": operator.mod,
    "mod": operator.mod,
    "floor_divide": operator.floordiv,
    "fmod": _fmod,
    "isclose": _is_close,
    "math.isclose": _is_close_by_math,
    "math.remainder": lambda x, period: x - round(x / period) * period,
    "isfinite": lambda x: True,
    "isnan": lambda x: False,
    "isinf": lambda x: False,
    "nan_to_num": lambda x: x,
}


def _parts(value: Numbers) -> Numbers:
    """Return the courses in an argument."""
    if isinstance(value, Course):
        yield value
    elif type(value) in (list, tuple) or type(value) is np.ndarray and value.dtype == object:
        for part in value.ravel() if type(value) is np.ndarray else value:
            yield from _parts(part)


def _replaced(value: Numbers, replace: Function) -> Numbers:
    """Return a copy of an argument with others in the place of its courses."""
    if isinstance(value, Course):
        return replace(value)
    if type(value) in (list, tuple):
        return type(value)(_replaced(part, replace) for part in value)
    if type(value) is np.ndarray and value.dtype == object:
        parts = np.empty(value.size, dtype=object)
        parts[:] = [_replaced(part, replace) for part in value.ravel()]
        keeps_courses = any(isinstance(part, Course) for part in parts)
        return (parts if keeps_courses else parts.astype(float)).reshape(value.shape)
    return value.copy() if type(value) is np.ndarray else value


def _lifted(function: Function) -> Numbers:
    """Return a function of numbers, and arrays of them, as one of courses."""
    name = getattr(function, "__name__", "")
    name = f"math.{name}" if function in (math.isclose, math.remainder) else name

    @functools.wraps(function, updated=())
    def lifted(*arguments: Numbers, **keywords: Numbers) -> Numbers:
        arguments = tuple(float if a is _Float else a for a in arguments)
        keywords = {key: float if a is _Float else a for key, a in keywords.items()}
        courses = [*_parts(arguments), *_parts(tuple(keywords.values()))]
        if not courses:
            result = function(*arguments, **keywords)
            return result.astype(object) if name in FILLED and result.dtype == float else result
        scalars = all(isinstance(a, Course | Real) for a in arguments)
        if name in SATURATING:
            courses[0].decisions.saturating += [c.slot for c in courses]
        if name in DECIDING:
            decide = functools.partial(DECIDING[name], **keywords)
            return decide(*arguments) if scalars else np.frompyfunc(decide, len(arguments), 1)(*arguments)
        if (
            scalars
            and not keywords
            and (smooth := getattr(np, NUMPY_NAMES.get(name, name), None))
            and isinstance(smooth, np.ufunc)
        ):
            if name == "tan":
                courses[0].decisions.denominators.append(_applied(np.cos, *arguments).slot)
            return _applied(smooth, *arguments)
        if not scalars and getattr(function, "__module__", "") == "numpy" or isinstance(function, np.ufunc):
            try:
                return function(*arguments, **keywords)
            except (TypeError, ValueError, AttributeError):
                pass
        return _point_by_point(function, courses, arguments, keywords)

    return lifted


def _point_by_point(function: Function, courses: list[Course], arguments: Numbers, keywords: Numbers) -> Numbers:
    """Return what a function makes of courses that nobody can look into: of tables the entries are seen."""
    for table in (*filter(_is_table, arguments), *_tables_of(function)):
        for course in courses:
            course.note_table(table)
    call = _replaced((arguments, tuple(keywords.values())), lambda course: course)  # the function may change them later

    def results(*values: Array) -> list[Numbers]:
        columns = {course.slot: v.tolist() for course, v in zip(courses, values, strict=True)}
        calls = [_replaced(call, lambda course, k=k: columns[course.slot][k]) for k in range(len(values[0]))]
        return [function(*positional, **dict(zip(keywords, named, strict=True))) for positional, named in calls]

    return _joined(_applied(results, *courses))


def _joined(results: Course) -> Numbers:
    """Return the courses of what came at each point."""
    first = results.values[0]
    if isinstance(first, tuple | list):
        parts = (_applied(lambda r, i=i: [part[i] for part in r], results) for i in range(len(first)))
        return type(first)(map(_joined, parts))
    array = np.asarray(first)
    if array.dtype.kind in "biu" and array.ndim == 0:  # it chose
        results.decisions.sign(_applied(lambda r: np.where(np.array(r) == first, 1.0, -1.0), results))
        return first
    flat = [_applied(lambda r, i=i: np.array([np.ravel(a)[i] for a in r], float), results) for i in range(array.size)]
    joined = np.empty(len(flat), dtype=object)
    joined[:] = flat
    return joined.reshape(array.shape) if array.ndim else flat[0]


def _is_table(value: Numbers) -> bool:
    """Return whether a value is an increasing list of numbers."""
    if not isinstance(value, list | tuple | np.ndarray):
        return False
    try:
        table = np.asarray(value, dtype=float)
    except (TypeError, ValueError):
        return False
    return table.ndim == 1 and 1 < table.size <= LARGEST_TABLE and bool((np.diff(table) >= 0).all())


def _tables_of(function: Function) -> list[Numbers]:
    """Return the tables that an object keeps, such as an interpolant of SciPy's."""
    if isinstance(function, types.FunctionType | types.BuiltinFunctionType | np.ufunc | type):
        return []
    tables = [getattr(function, name, None) for name in dir(function) if name[0] != "_"]
    return [table for table in tables if isinstance(table, np.ndarray) and _is_table(table)]


class _LiftedModule:
    """A module whose functions take courses."""

    def __init__(self, module: types.ModuleType) -> None:
        self.module = module

    def __getattr__(self, name: str) -> Numbers:
        value = substituted(getattr(self.module, name), _substitute, STAND_INS)
        setattr(self, name, value)  # it is asked for once
        return value


def _substitute(value: Numbers) -> Numbers:
    """Return what stands in for a value in a function of courses; itself where it is to be looked into."""
    if isinstance(value, types.ModuleType):
        return _LiftedModule(value)
    if isinstance(value, types.BuiltinFunctionType):
        return value if value.__module__ == "builtins" else _lifted(value)
    if isinstance(value, types.FunctionType):
        return _lifted(value) if _is_foreign(value) else value
    if isinstance(value, type | functools.partial) or not callable(value):
        return value
    method = value if isinstance(value, types.MethodType) else types.MethodType(type(value).__call__, value)
    if isinstance(method.__func__, types.FunctionType) and not _is_foreign(method.__func__):
        return types.MethodType(substituted(method.__func__, _substitute, STAND_INS), _copied(method.__self__))
    return _lifted(value)


def _copied(instance: Numbers) -> Numbers:
    """Return an instance with copies of its lists and their like: what its methods put there stays the copy's."""
    if isinstance(instance, type) or not hasattr(instance, "__dict__"):
        return instance
    twin = copy.copy(instance)
    for name, value in vars(instance).items():
        twin.__dict__[name] = copy.copy(value) if isinstance(value, list | dict | set) else _substitute(value)
    return twin


def _is_foreign(function: types.FunctionType) -> bool:
    module = function.__module__ or ""
    return module.partition(".")[0] != OURS and function.__code__.co_filename.startswith(FOREIGN)


class _FloatType(type):
    def __instancecheck__(cls, value: Numbers) -> bool:
        return isinstance(value, float | Course)


class _Float(metaclass=_FloatType):
    """What stands in for float."""

    def __new__(cls, value: Numbers = 0.0) -> Numbers:
        if isinstance(value, np.ndarray) and value.shape == () and value.dtype == object:
            value = value.item()
        return value if isinstance(value, Course) else float(value)


def _isinstance(value: Numbers, kinds: Numbers) -> bool:
    return isinstance(1.0 if isinstance(value, Course) else value, kinds)


STAND_INS = {"float": _Float, "isinstance": _isinstance}


def along(rates: Function, size: int) -> Callable[[Array, Array], Decisions]:
    """Return profile(t, y): what rates(t, y) decides by at (m,) times and (k, m) states."""
    twin = substituted(rates, _substitute, STAND_INS)

    def profile(t: Array, y: Array) -> Decisions:
        decisions = Decisions(t, y)
        state = np.empty(size, dtype=object)
        state[:] = [Course(decisions, i + 1) for i in range(size)]
        twin(Course(decisions, 0, is_line=True), state)
        decisions.forget_results()
        return decisions

    return profile
