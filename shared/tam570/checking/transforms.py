"""Transforms: the right function with its arguments or results changed, as by frequent mistakes.

The grader compares a student's numbers with them if no known mistake explains these; `tam570 check` tries the inverses.
"""

import functools
import inspect
import math
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import combinations, permutations, product
from typing import Protocol

import numpy as np

from tam570.values import Function, Numbers, Parameters

SPACE = 3  # components of a vector
ORDINALS = ("first ", "second ", "third ", "fourth ", "fifth ", "sixth ")  # results of a function
AXES = {1: ("component",), 2: ("row", "column"), 3: ("segment", "end", "component")}  # by the number of axes
SHARE = 1e-4  # factor on initial values, small enough that results are linear in them to 1e-8
MOST = 8  # length of an axis, up to which one or two components are changed


class Arguments(Protocol):
    """The arguments of a call."""

    @property
    def args(self) -> Sequence[Numbers]: ...
    @property
    def kwargs(self) -> Parameters: ...


class Compared(Protocol):
    """A call, its result, and the right result."""

    @property
    def case(self) -> Arguments: ...
    @property
    def result(self) -> Numbers: ...
    @property
    def expected(self) -> Numbers: ...


Transform = tuple[str, Callable[[Compared], Numbers]]  # message, and function that returns the wrong answer
Change = Callable[[Numbers], Numbers]
ResultChange = Callable[[Numbers, Arguments], Numbers]
FACTORS = {
    "has the opposite sign": -1.0,
    "is twice as large as the right one": 2.0,
    "is half as large as the right one": 0.5,
    "is in degrees": 180 / math.pi,
    "lacks the factor pi": 1 / math.pi,
    "lacks the factor 2 pi": 1 / (2 * math.pi),
    "has a factor pi too many": math.pi,
    "has a factor 2 pi too many": 2 * math.pi,
    "lacks the factor sqrt(2)": math.sqrt(0.5),
    "has a factor sqrt(2) too many": math.sqrt(2),
}
PARTS = {"is twice as large as the right one": 2.0, "is half as large as the right one": 0.5}  # of one component


def _into_turn(turn: float, angle: Numbers) -> Numbers:
    return angle - turn * np.round(np.asarray(angle) / turn)


WITHOUT_SIGN = "lacks its sign: it is the absolute value of the right one"
POWERS: dict[str, Change] = {
    "is the square of the right one": np.square,
    "is the square root of the right one": np.sqrt,
    "is one over the right one": np.reciprocal,
    WITHOUT_SIGN: np.abs,
    "is zero where the right one is negative": partial(np.maximum, 0.0),
    "is the square root of the right one, and zero where that is negative": lambda value: np.sqrt(np.maximum(value, 0)),
    "is the arctan of a ratio, which has lost a half turn; use arctan2": partial(_into_turn, math.pi),
    "is wrapped to less than half a turn either way": partial(_into_turn, 2 * math.pi),
}
GRAVITY = 9.81  # m/s^2
THIN: dict[str, Change] = {
    "{} is that of a thin disk, A = C/2, whatever A is": lambda inertia: (inertia[1] / 2, inertia[1]),
    "{} is that of a thin disk, C = 2 A, whatever C is": lambda inertia: (inertia[0], 2 * inertia[0]),
}
LENGTHS = ("radius", "length", "offset")  # possible distances between reference points of a moment of inertia
ANGLES = ("angle", "lean", "phi", "slope", "theta", "tilt")
TURNS: dict[str, Change] = {
    "is taken modulo pi": lambda angle: np.mod(angle, math.pi),
    "is taken modulo pi, from -pi/2 to pi/2": partial(_into_turn, math.pi),
    "is taken modulo 2 pi": lambda angle: np.mod(angle, 2 * math.pi),
    "is wrapped to less than half a turn either way": partial(_into_turn, 2 * math.pi),
}
INERTIA = re.compile("inertia$")


@dataclass(frozen=True)
class WrongArgument:
    """Transform that calls the right function with another value of one argument."""

    reference: Function
    key: str
    change: Change

    def __call__(self, call: Compared) -> Numbers:
        return self.reference(**self.arguments(self.reference, call.case))

    def arguments(self, function: Function, case: Arguments) -> dict[str, Numbers]:
        """Return the arguments of a call by name, with this one changed if the function has it."""
        values = _named(function, case)
        return {name: self.change(value) if name == self.key else value for name, value in values.items()}


def other_results(name: str, reference: Function, example: Compared, vary: bool) -> Iterator[Transform]:
    """Yield transforms to a result with the wrong sign, unit or factor, or with exchanged components.

    example : a call with a wrong result
    vary    : whether parameters differ between calls, so that a constant factor cannot depend on them
    """
    results, expected = parts(example.result), parts(example.expected)
    numbers = {key: position for key, position in _numbers(reference, example.case).items() if position is None}
    for which, (label, returned) in enumerate(zip(_labels(name, len(results)), results, strict=False)):
        changes = [(words, change) for words, change, _ in _changes(np.asarray(returned), numbers)]
        like_result = {
            key: None for key, value in example.case.kwargs.items() if np.shape(value) == np.shape(returned) != ()
        }
        changes += [(f"{words}, component by component", change) for words, change, _ in _multiples(like_result)]
        if vary and which < len(expected):
            changes += _constants(np.asarray(returned), np.asarray(expected[which]))
        for words, change in changes:
            yield f"{label} {words}", partial(_with_result, which, len(results), change)
    if len(results) > 1:
        yield from _of_all_results(name, len(results))


def other_factors(name: str, reference: Function, example: Compared) -> Iterator[Transform]:
    """Yield transforms to a result in which a positional argument is a factor too few or too many."""
    results = parts(example.result)
    numbers = {key: position for key, position in _numbers(reference, example.case).items() if position is not None}
    for which, label in enumerate(_labels(name, len(results))):
        for words, change, _ in _multiples(numbers):
            yield f"{label} {words}", partial(_with_result, which, len(results), change)


def _labels(name: str, count: int) -> list[str]:
    """Return the name of each result of a function, for messages."""
    return [f"Your {ordinal if count > 1 else ''}result of {name}" for ordinal in ORDINALS[:count]]


def _of_all_results(name: str, count: int) -> Iterator[Transform]:
    """Yield transforms of several results together, each of which is its own inverse."""
    yield f"Your results of {name} have the opposite sign", lambda call: tuple(map(np.negative, parts(call.expected)))
    if count == 2:
        yield f"Your results of {name} are exchanged", lambda call: tuple(parts(call.expected)[::-1])


def other_arguments(name: str, reference: Function, example: Compared) -> Iterator[Transform]:
    """Yield transforms with an argument of the wrong sign, in degrees, ignored, or exchanged with another."""
    values = _named(reference, example.case)
    for key, value in values.items():
        thin = THIN.items() if INERTIA.search(key) and np.shape(value) == (2,) else ()
        for words, change in (*((words, change) for words, change, _ in _other_values(np.asarray(value))), *thin):
            yield f"In {name}, {words.format(key)}", WrongArgument(reference, key, change)
    if "gravity" in values:
        words = f"In {name}, gravity is ignored, as if it were {GRAVITY}"
        yield words, WrongArgument(reference, "gravity", lambda value: GRAVITY)
    yield from _other_points(name, reference, values)
    yield from _exchanges(name, reference, values)


def other_symbols(name: str, points: Sequence[Parameters]) -> Iterator[tuple[str, Change]]:
    """Yield changes of points: a formula's symbol has the wrong sign, counts twice, is ignored or exchanged."""
    for key in points[0]:
        for words, change, _ in _other_values(np.asarray(1.0)):
            yield f"In {name}, {words.format(key)}", partial(_at_points, {key: (key, change)})
    for first, other in combinations(points[0], 2):
        exchange = {first: (other, np.positive), other: (first, np.positive)}
        yield f"In {name}, {first} and {other} are exchanged", partial(_at_points, exchange)


def _at_points(changes: Mapping[str, tuple[str, Change]], points: Sequence[Parameters]) -> list[Parameters]:
    def changed(point: Parameters) -> Parameters:
        return {**point, **{key: change(point[other]) for key, (other, change) in changes.items() if key in point}}

    return [changed(point) if {other for other, _ in changes.values()} <= point.keys() else point for point in points]


def other_words(name: str, reference: Function, cases: Iterable[Arguments]) -> Iterator[Transform]:
    """Yield transforms that exchange two values of a string argument, among those in the calls."""
    values = [_named(reference, case) for case in cases]
    for key in _parameters(reference):
        words = sorted({value[key] for value in values if isinstance(value.get(key), str)})
        for first, other in combinations(words, 2):
            message = f"In {name}, {key} = {first!r} and {key} = {other!r} are exchanged"
            yield message, WrongArgument(reference, key, partial(_other_word, first, other))


def _other_word(first: str, other: str, word: str) -> str:
    return {first: other, other: first}.get(word, word)


def undone(name: str, function: Function, example: Compared, is_quick: bool) -> Iterator[Transform]:
    """Yield possible mistakes of a student's function, with functions that return its results with the mistake undone.

    example  : a call of the function, with the student's result as `expected`
    is_quick : whether the function is quick enough to call it with many other arguments
    """
    results, numbers = parts(example.expected), _numbers(function, example.case)
    for which, label in enumerate(_labels(name, len(results))):
        for words, _, undo in (*_changes(np.asarray(results[which]), numbers), UNWRAPPED):
            if undo:
                yield f"{label} {words}", partial(_with_result, which, len(results), undo)
    if len(results) > 1:
        yield from _of_all_results(name, len(results))
    values = _named(function, example.case)
    for key, value in values.items():
        undone_values = [(words, back) for words, _, back in _other_values(np.asarray(value))] if is_quick else []
        for words, back in (*undone_values, *UNPREPARED.get(key, ())):
            if back:
                yield f"In {name}, {words.format(key)}", WrongArgument(function, key, back)
    if is_quick:
        yield from _exchanges(name, function, values)


def _exchanges(name: str, function: Function, values: Parameters) -> Iterator[Transform]:
    for first, other in combinations(values, 2):
        if np.shape(values[first]) == np.shape(values[other]):
            yield f"In {name}, {first} and {other} are exchanged", partial(_exchanged, function, first, other)


def other_forms(name: str, reference: Function, example: Compared) -> Iterator[Transform]:
    """Yield rarer transforms: an argument without sign, in other axes or without a step; a sine or cosine too many.

    After these, exchanged components of an argument and the result, and results linear in the initial values.
    """
    names = _parameters(reference)
    values = _named(reference, example.case)
    for key, value in values.items():
        for words, change in _rarer_values(key, value):
            yield f"In {name}, {words.format(key)}", WrongArgument(reference, key, change)
    yield from _other_axes(name, reference, values)
    yield from _other_factors(name, reference, example)
    starts = [key for key in names[: len(example.case.args)] if np.asarray(values[key]).dtype.kind in "fi"]
    starts = [key for key in starts if key != "t"]
    single = [[key] for key in starts if np.size(values[key]) <= SPACE]
    shape = () if isinstance(example.expected, tuple) else np.shape(example.expected)
    for key in (key for key in starts if len(shape) == 1 and np.shape(values[key]) == shape):
        for j, k in combinations(range(*shape), 2):
            words = f"In {name}, {key} and the result have components {j + 1} and {k + 1} exchanged"
            yield words, partial(_relabelled, reference, key, [j, k])
    count = min(len(parts(example.result)), len(ORDINALS))
    for keys in [*single, *([starts] if len(starts) > 1 or not single else [])]:
        for which in (None, *range(count if count > 1 else 0)):
            ordinal = "" if which is None else ORDINALS[which]
            words = f"Your {ordinal}result of {name} is linear in {', '.join(keys)}, as for small motions"
            yield words, partial(_linearised, reference, keys, which)


def _rarer_values(key: str, value: Numbers) -> Iterator[tuple[str, Change]]:
    """Yield rarer changes of an argument: a number without its sign or turns, steps without an end or their order."""
    if isinstance(value, list) and len(value) > 1 and isinstance(value[0], tuple):
        yield "the first of the {} is left out", lambda value: value[1:]
        yield "the last of the {} is left out", lambda value: value[:-1]
        yield "the order of the {} is reversed", lambda value: value[::-1]
    elif np.asarray(value).dtype.kind in "fi":
        yield "{} has lost its sign", np.abs
        for words, change in TURNS.items() if key in ANGLES else ():
            yield f"{{}} {words}", change


def _other_axes(name: str, reference: Function, values: Parameters) -> Iterator[Transform]:
    """Yield transforms with a vector in the other frame's axes, if the arguments include a rotation R."""
    vectors = [key for key, value in values.items() if np.shape(value) == (SPACE,)]
    for key in vectors if np.shape(values.get("R", 0)) == (SPACE, SPACE) else ():
        yield f"In {name}, {key} is used as if it had space components", partial(_in_other_axes, reference, key, True)
        yield f"In {name}, {key} is multiplied by R once more", partial(_in_other_axes, reference, key, False)


def _in_other_axes(reference: Function, key: str, back: bool, call: Compared) -> Numbers:
    values = _named(reference, call.case)
    rotation = np.asarray(values["R"])
    return reference(**{**values, key: (rotation.T if back else rotation) @ values[key]})


def _other_factors(name: str, reference: Function, example: Compared) -> Iterator[Transform]:
    """Yield transforms to a result with the sine or cosine of an angle as a factor too many or too few."""
    values, results = _named(reference, example.case), parts(example.result)
    angles = [key for key, value in values.items() if np.ndim(value) == 0 and key in ANGLES]
    for (which, label), key in product(enumerate(_labels(name, len(results))), angles):
        for function, (words, power) in product((np.cos, np.sin), {"too many": 1, "too few": -1}.items()):
            change = partial(_times_function, reference, function, key, power)
            message = f"{label} has a factor {function.__name__}({key}) {words}"
            yield message, partial(_with_result, which, len(results), change)


def _times_function(
    reference: Function, function: Change, key: str, power: int, value: Numbers, case: Arguments
) -> Numbers:
    return value * function(_named(reference, case)[key]) ** power


def _linearised(reference: Function, keys: Sequence[str], which: int | None, call: Compared) -> Numbers:
    values = _named(reference, call.case)

    def at(share: float) -> list[Numbers]:
        changed = {key: np.multiply(values[key], share) for key in keys}
        return [np.asarray(part, float) for part in parts(reference(**{**values, **changed}))]

    linear = [zero + (up - down) / (2 * SHARE) for zero, up, down in zip(at(0.0), at(SHARE), at(-SHARE), strict=True)]
    results = [linear[k] if which in (None, k) else part for k, part in enumerate(parts(call.expected))]
    return tuple(results) if isinstance(call.expected, tuple) else results[0]


def _other_points(name: str, reference: Function, values: Parameters) -> Iterator[Transform]:
    """Yield transforms with a moment of inertia about the wrong point, or of a thin uniform disk."""
    if np.shape(values.get("inertia", 0)) == (2,) and {"mass", "radius"} <= values.keys():
        yield f"In {name}, inertia is that of a thin uniform disk, whatever it is", partial(_uniform, reference)
    lengths = [key for key in values if key in LENGTHS and "mass" in values]
    for key, length, power in product(filter(INERTIA.search, values), lengths, (1, -1)):
        for k in range(np.size(values[key])):
            which = f"component {k + 1} of {key}" if np.ndim(values[key]) else key
            words = f"has mass {length}^2 too many" if power > 0 else f"lacks mass {length}^2"
            yield f"In {name}, {which} {words}", partial(_about_another_point, reference, key, k, length, power)


def other_products(name: str, reference: Function, example: Compared) -> Iterator[Transform]:
    """Yield transforms with an argument that another one, or the root of a ratio, multiplies by mistake, or should."""
    values = {key: np.asarray(value) for key, value in _named(reference, example.case).items()}
    numbers = [key for key, value in values.items() if value.dtype.kind in "fiu"]
    for key, other in permutations(numbers, 2):
        if values[other].ndim == 0:
            missing, extra = (partial(_with_product, reference, key, {other: power}) for power in (-1, 1))
            yield f"In {name}, {key} lacks a factor {other}", missing
            yield f"In {name}, {key} has a factor {other} too many", extra
    parameters = [key for key in numbers if key in example.case.kwargs and values[key].ndim == 0]
    starts = [key for key in numbers if key not in example.case.kwargs and key != "t"]
    for key, (over, under) in product(starts, permutations(parameters, 2)):
        root = partial(_with_product, reference, key, {over: 0.5, under: -0.5})
        yield f"In {name}, {key} should be divided by sqrt({over}/{under})", root


def _numbers(function: Function, case: Arguments) -> dict[str, int | None]:
    """Return the arguments that are single numbers, each with its position; None for a keyword argument."""
    places = {key: position for position, key in enumerate(_parameters(function)[: len(case.args)])}
    numbers = {key: np.asarray(value) for key, value in _named(function, case).items()}
    return {key: places.get(key) for key, value in numbers.items() if value.ndim == 0 and value.dtype.kind in "fiu"}


def _changes(
    result: Numbers, numbers: Mapping[str, int | None]
) -> Iterator[tuple[str, ResultChange, ResultChange | None]]:
    """Yield possible changes of a result: message, change, and inverse or None."""
    for words, factor in FACTORS.items():
        yield words, partial(_scaled, factor), partial(_scaled, 1 / factor)
    for words, change in POWERS.items():
        yield words, partial(_changed, change), None
    yield from _multiples(numbers)
    if result.ndim == 1 and len(result) > SPACE and not len(result) % 2:
        yield from _multiples(numbers, len(result) // 2)
    if result.ndim == 2 and result.shape[0] == result.shape[1]:
        transposed = partial(_changed, np.transpose)
        yield "is transposed", transposed, transposed
        for j, k in combinations(range(len(result) if SPACE <= len(result) <= MOST else 0), 2):
            exchanged = partial(_changed, partial(_transposed_in, j, k))
            yield f"has the elements ({j + 1}, {k + 1}) and ({k + 1}, {j + 1}) exchanged", exchanged, exchanged
    if result.ndim == SPACE and result.shape[1] == result.shape[2]:
        later = partial(_changed, lambda value: np.concatenate([value[:1], np.swapaxes(value[1:], 1, 2)]))
        yield "is transposed in all rows but the first", later, later
    for words, change in _components(result):
        yield words, partial(_changed, change), partial(_changed, change)
    if result.ndim == 1 and SPACE <= len(result) <= MOST:
        for j, k in combinations(range(len(result)), 2):
            reversed_ = partial(_changed, partial(np.multiply, [(-1.0) ** (i in (j, k)) for i in range(len(result))]))
            yield f"has the opposite sign in components {j + 1} and {k + 1}", reversed_, reversed_
    for axis, what in enumerate(AXES.get(result.ndim, ())):
        count = result.shape[axis]
        for k, (words, factor) in product(range(count if count <= MOST else 0), PARTS.items()):
            change, undo = (partial(_changed, partial(_scaled_part, k, axis, power)) for power in (factor, 1 / factor))
            yield f"{words} in {what} {k + 1}", change, undo


def _multiples(numbers: Mapping[str, int | None], last: int = 0) -> Iterator[tuple[str, ResultChange, ResultChange]]:
    """Yield changes of a result whose last components, or all, lack a factor or divisor, one of these arguments."""
    where = f" in its last {last} components" if last else ""
    powers = {"multiplied by {}": -1, "divided by {}": 1, "multiplied by {} squared": -2, "divided by {} squared": 2}
    for number, (words, power) in product(numbers.items(), powers.items()):
        times = partial(_times, number, last)
        yield f"should be {words.format(number[0])}{where}", partial(times, power), partial(times, -power)


def _constants(result: Numbers, expected: Numbers) -> Iterator[tuple[str, ResultChange]]:
    """Yield the constant factor and the constant offset of a result from the right one, as messages and changes."""
    if result.shape == expected.shape and expected.any():
        largest = np.unravel_index(np.argmax(np.abs(expected)), expected.shape)
        ratio, shift = (float(array[largest]) for array in (result / expected[largest], result - expected))
        yield f"is {ratio:.4g} times the right one" if ratio else "is zero", partial(_scaled, ratio)
        if expected.ndim == 0:
            yield f"is off by {shift:.4g}", partial(_changed, partial(np.add, shift))


def _scaled(factor: float, value: Numbers, case: Arguments) -> Numbers:
    return value * factor


def _times(number: tuple[str, int | None], last: int, power: int, value: Numbers, case: Arguments) -> Numbers:
    """Multiply the last components, or all, by a power of an argument, a keyword or the one at its position."""
    key, position = number
    factor = np.asarray(case.kwargs[key] if position is None else case.args[position], float) ** power
    return value * (np.repeat([1.0, factor], last) if last else factor)


def _changed(change: Change, value: Numbers, case: Arguments) -> Numbers:
    return change(value)


def _components(result: Numbers) -> Iterator[tuple[str, Change]]:
    """Yield changes of a component, row or column: the wrong sign, or exchanged with another; each is its inverse."""
    for axis, (what, count) in enumerate(zip(AXES.get(result.ndim, ()), result.shape, strict=False)):
        numbers = range(count if count <= MOST else 0)
        for k in numbers:
            yield f"has the opposite sign in {what} {k + 1}", partial(_scaled_part, k, axis, -1.0)
        for j, k in combinations(numbers, 2):
            order = np.arange(count)
            order[[j, k]] = k, j
            yield f"has {what}s {j + 1} and {k + 1} exchanged", partial(np.take, indices=order, axis=axis)
        if count > 2 and not count % 2:
            half = count // 2
            yield f"has its first and last {half} {what}s exchanged", partial(np.roll, shift=half, axis=axis)


def _transposed_in(j: int, k: int, value: Numbers) -> Numbers:
    changed = np.array(value)
    changed[[j, k], [k, j]] = changed[[k, j], [j, k]]
    return changed


def _scaled_part(which: int, axis: int, factor: float, value: Numbers) -> Numbers:
    factors = np.where(np.arange(np.shape(value)[axis]) == which, factor, 1.0)
    return np.moveaxis(np.moveaxis(np.asarray(value), axis, -1) * factors, -1, axis)


VALUES: tuple[tuple[str, Change, Change | None], ...] = (  # message, change, inverse or None
    ("{} has the opposite sign", np.negative, np.negative),
    ("{} is converted to degrees", np.degrees, np.radians),
    ("{} is read as degrees", np.radians, np.degrees),
    ("{} counts twice", partial(np.multiply, 2.0), partial(np.multiply, 0.5)),
    ("{} counts half", partial(np.multiply, 0.5), partial(np.multiply, 2.0)),
    ("{} is ignored, as if it were zero", partial(np.multiply, 0.0), None),
)


def _other_values(value: Numbers) -> Iterator[tuple[str, Change, Change | None]]:
    """Yield possible changes of an argument: message, change, and inverse or None."""
    if value.dtype.kind not in "fiu":
        return
    if value.ndim != 1 or len(value) <= SPACE:  # a longer one is a state of different quantities
        yield from VALUES
    if value.ndim == 0:
        yield "{} is ignored, as if it were 1", lambda value: 1.0, None
    if value.ndim == 2 and value.shape[0] == value.shape[1]:
        yield "{} is transposed", np.transpose, np.transpose
    for words, change in _components(value):
        yield f"{{}} {words}", change, change


def parts(result: Numbers) -> list[Numbers]:
    """Return the results of a call as a list."""
    return list(result) if isinstance(result, tuple) else [result]


# what a function may forget to do with an argument of this name: subtract t[0], normalize the axis
UNPREPARED: dict[str, tuple[tuple[str, Change], ...]] = {
    "t": (("the first time is taken as 0: it is t[0]", lambda t: np.asarray(t) - t[0]),),
    "axis": (("{} is used as if it were a unit vector", lambda axis: np.asarray(axis) / np.linalg.norm(axis)),),
}
UNWRAPPED = "is wrapped to one turn", None, lambda value, case: np.unwrap(value, axis=0) if np.ndim(value) else value


def _with_result(which: int, count: int, change: ResultChange, call: Compared) -> Numbers:
    results = parts(call.expected) if count > 1 else [call.expected]  # a vector may be a tuple of numbers
    results[which] = change(np.asarray(results[which]), call.case)
    return tuple(results) if count > 1 else results[0]


def _with_product(reference: Function, key: str, powers: Mapping[str, float], call: Compared) -> Numbers:
    values = _named(reference, call.case)
    factor = math.prod(float(values[other]) ** power for other, power in powers.items())
    return reference(**{**values, key: np.asarray(values[key]) * factor})


def _about_another_point(reference: Function, key: str, k: int, length: str, power: int, call: Compared) -> Numbers:
    values = _named(reference, call.case)
    inertia = np.array(values[key], float)
    inertia.flat[k] += power * float(values["mass"]) * float(values[length]) ** 2
    return reference(**{**values, key: inertia if inertia.ndim else float(inertia)})


def _uniform(reference: Function, call: Compared) -> Numbers:
    values = _named(reference, call.case)
    size = float(values["mass"]) * float(values["radius"]) ** 2
    return reference(**{**values, "inertia": (size / 4, size / 2)})


def _relabelled(reference: Function, key: str, pair: list[int], call: Compared) -> Numbers:
    values = _named(reference, call.case)
    order = np.arange(len(values[key]))
    order[pair] = pair[::-1]
    return np.take(reference(**{**values, key: np.take(values[key], order)}), order)


def _exchanged(reference: Function, first: str, other: str, call: Compared) -> Numbers:
    values = _named(reference, call.case)
    return reference(**{**values, first: values[other], other: values[first]})


def _named(function: Function, case: Arguments) -> dict[str, Numbers]:
    """Return the arguments of a call by the names of the function's parameters."""
    return {**dict(zip(_parameters(function), case.args, strict=False)), **case.kwargs}


@functools.lru_cache(maxsize=256)
def _parameters(function: Function) -> tuple[str, ...]:
    return tuple(inspect.signature(function).parameters)
