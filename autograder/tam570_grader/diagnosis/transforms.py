"""Wrong answers that are made of the right function: its arguments or its result changed, in ways that people err."""

import inspect
import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import combinations, permutations, product
from typing import Any

import numpy as np

from tam570_grader.checks.case import Case
from tam570_grader.diagnosis.compared_call import Judged
from tam570_grader.diagnosis.mistakes import parts

__all__ = ["WrongArgument", "other_arguments", "other_forms", "other_products", "other_results"]

SPACE = 3  # components of a vector
ORDINALS = ("first ", "second ", "third ", "fourth ", "fifth ", "sixth ")  # results of a function
AXES = {1: ("component",), 2: ("row", "column"), 3: ("segment", "end", "component")}  # of an array, by their number
SHARE = 1e-4  # of what a motion starts from: its result is linear in it to 1e-8
MOST = 8  # along an axis, of which one, or two, may be wrong
Variant = tuple[str, Callable[[Judged], Any]]  # what to say, and the wrong answer
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


def _into_turn(turn: float, angle: Any) -> Any:
    return angle - turn * np.round(np.asarray(angle) / turn)


POWERS: dict[str, Callable[[Any], Any]] = {
    "is the square of the right one": np.square,
    "is the square root of the right one": np.sqrt,
    "is one over the right one": np.reciprocal,
    "has lost its sign": np.abs,
    "is zero where the right one is negative": partial(np.maximum, 0.0),
    "is the square root of the right one, and zero where that is negative": lambda value: np.sqrt(np.maximum(value, 0)),
    "is the arctan of a ratio, which has lost a half turn; use arctan2": partial(_into_turn, math.pi),
    "is wrapped to less than half a turn either way": partial(_into_turn, 2 * math.pi),
}
GRAVITY = 9.81  # m/s^2
THIN: dict[str, Callable[[Any], Any]] = {
    "{} is that of a thin disk, A = C/2, whatever A is": lambda inertia: (inertia[1] / 2, inertia[1]),
    "{} is that of a thin disk, C = 2 A, whatever C is": lambda inertia: (inertia[0], 2 * inertia[0]),
}
LENGTHS = ("radius", "length", "offset")  # from one point to the other, of a moment of inertia
INERTIA = re.compile("inertia$")


@dataclass(frozen=True)
class WrongArgument:
    """The right function with another value of one argument."""

    right: Callable[..., Any]
    key: str
    change: Callable[[Any], Any]

    def __call__(self, call: Judged) -> Any:
        return self.right(**self.arguments(self.right, call.case))

    def arguments(self, function: Callable[..., Any], case: Case) -> dict[str, Any]:
        """What a function gets in its place; unchanged where it does not take this argument."""
        values = _named(list(inspect.signature(function).parameters), case)
        return {name: self.change(value) if name == self.key else value for name, value in values.items()}


def other_results(name: str, example: Judged, vary: bool) -> Iterator[Variant]:
    """A result of the wrong sign, in another unit, by a factor too large, with parts exchanged.

    example : a wrong call
    vary    : the parameters differ from call to call: what is the same in all of them does not depend on these
    """
    results, expected = parts(example.result), parts(example.right)
    numbers = [key for key, value in example.case.kwargs.items() if np.ndim(value) == 0]
    for which, (place, found) in enumerate(zip(ORDINALS, results, strict=False)):
        label = f"The {place}result of {name}" if len(results) > 1 else f"The result of {name}"
        changes = list(_changes(np.asarray(found), numbers))
        if vary and which < len(expected):
            changes += _constants(np.asarray(found), np.asarray(expected[which]))
        for says, change in changes:
            yield f"{label} {says}", partial(_with_result, which, len(results), change)
    if len(results) > 1:
        yield f"The results of {name} have the opposite sign", _reversed


def other_arguments(name: str, right: Callable[..., Any], example: Judged) -> Iterator[Variant]:
    """An argument of the wrong sign, in degrees, ignored, or in another's place."""
    taken = list(inspect.signature(right).parameters)
    values = _named(taken, example.case)
    for key, value in values.items():
        thin = THIN.items() if INERTIA.search(key) and np.shape(value) == (2,) else ()
        for says, change in (*_other_values(np.asarray(value)), *thin):
            yield f"In {name}, {says.format(key)}", WrongArgument(right, key, change)
    if "gravity" in values:
        says = f"In {name}, gravity is ignored, as if it were {GRAVITY}"
        yield says, WrongArgument(right, "gravity", lambda value: GRAVITY)
    yield from _other_points(name, right, taken, values)
    for one, other in combinations(values, 2):
        if np.shape(values[one]) == np.shape(values[other]):
            yield f"In {name}, {one} and {other} are exchanged", partial(_exchanged, right, taken, one, other)


def other_forms(name: str, right: Callable[..., Any], example: Judged) -> Iterator[Variant]:
    """A result that is linear in what it starts from, or one of several results; components of both exchanged."""
    taken = list(inspect.signature(right).parameters)
    values = _named(taken, example.case)
    starts = [key for key in taken[: len(example.case.args)] if np.asarray(values[key]).dtype.kind in "fi"]
    starts = [key for key in starts if key != "t"]
    single = [[key] for key in starts if np.size(values[key]) <= SPACE]
    shape = () if isinstance(example.right, tuple) else np.shape(example.right)
    for key in (key for key in starts if len(shape) == 1 and np.shape(values[key]) == shape):
        for j, k in combinations(range(*shape), 2):
            says = f"In {name}, {key} and the result have components {j + 1} and {k + 1} exchanged"
            yield says, partial(_relabelled, right, taken, key, [j, k])
    count = len(parts(example.right))
    for keys in [*single, *([starts] if len(starts) > 1 or not single else [])]:
        for which in (None, *range(count if count > 1 else 0)):
            place = "" if which is None else ORDINALS[which]
            says = f"The {place}result of {name} is linear in {', '.join(keys)}, as for small motions"
            yield says, partial(_linearised, right, taken, keys, which)


def _linearised(
    right: Callable[..., Any], taken: Sequence[str], keys: Sequence[str], which: int | None, call: Judged
) -> Any:
    values = _named(taken, call.case)

    def at(share: float) -> list[Any]:
        changed = {key: np.multiply(values[key], share) for key in keys}
        return [np.asarray(part, float) for part in parts(right(**{**values, **changed}))]

    linear = [zero + (up - down) / (2 * SHARE) for zero, up, down in zip(at(0.0), at(SHARE), at(-SHARE), strict=True)]
    results = [linear[k] if which in (None, k) else part for k, part in enumerate(parts(call.right))]
    return tuple(results) if isinstance(call.right, tuple) else results[0]


def _other_points(name: str, right: Any, taken: Sequence[str], values: Mapping[str, Any]) -> Iterator[Variant]:
    """A moment of inertia about another point than the right one."""
    lengths = [key for key in values if key in LENGTHS and "mass" in values]
    for key, length, power in product(filter(INERTIA.search, values), lengths, (1, -1)):
        for k in range(np.size(values[key])):
            which = f"component {k + 1} of {key}" if np.ndim(values[key]) else key
            says = f"has mass {length}^2 too many" if power > 0 else f"lacks mass {length}^2"
            yield f"In {name}, {which} {says}", partial(_about_another_point, right, taken, key, k, length, power)


def other_products(name: str, right: Callable[..., Any], example: Judged) -> Iterator[Variant]:
    """A factor that is missing beside an argument, or one too many."""
    taken = list(inspect.signature(right).parameters)
    values = {key: np.asarray(value) for key, value in _named(taken, example.case).items()}
    numbers = [key for key, value in values.items() if value.dtype.kind in "fiu"]
    for key, other in permutations(numbers, 2):
        if values[other].ndim == 0:
            missing, extra = (partial(_with_product, right, taken, key, other, power) for power in (-1, 1))
            yield f"In {name}, {key} lacks a factor {other}", missing
            yield f"In {name}, {key} has a factor {other} too many", extra


def _changes(found: Any, numbers: Sequence[str]) -> Iterator[tuple[str, Callable[[Any, Case], Any]]]:
    """What may be wrong with a result."""
    for says, factor in FACTORS.items():
        yield says, partial(_scaled, factor)
    for says, change in POWERS.items():
        yield says, partial(_changed, change)
    for key in numbers:
        for says, power in {"multiplied": -1, "divided": 1}.items():
            yield f"should be {says} by {key}", partial(_times, key, power)
            yield f"should be {says} by {key} squared", partial(_times, key, 2 * power)
    if found.ndim == 2 and found.shape[0] == found.shape[1]:
        yield "is transposed", lambda value, case: np.transpose(value)
    for says, change in _components(found):
        yield says, partial(_changed, change)


def _constants(found: Any, right: Any) -> Iterator[tuple[str, Callable[[Any, Case], Any]]]:
    """What one result is of the right one, given that it is so for any input."""
    if found.shape == right.shape and right.any():
        largest = np.unravel_index(np.argmax(np.abs(right)), right.shape)
        ratio, shift = (float(one[largest]) for one in (found / right[largest], found - right))
        yield f"is {ratio:.4g} times the right one for any input", partial(_scaled, ratio)
        if right.ndim == 0:
            yield f"is off by {shift:.4g} for any input", partial(_changed, partial(np.add, shift))


def _scaled(factor: float, value: Any, case: Case) -> Any:
    return value * factor


def _times(key: str, power: int, value: Any, case: Case) -> Any:
    return value * case.kwargs[key] ** power


def _changed(change: Callable[[Any], Any], value: Any, case: Case) -> Any:
    return change(value)


def _components(found: Any) -> Iterator[tuple[str, Callable[[Any], Any]]]:
    """One component of a vector, one row or column, of the wrong sign; two exchanged."""
    for axis, (what, count) in enumerate(zip(AXES.get(found.ndim, ()), found.shape, strict=False)):
        numbers = range(count if count <= MOST else 0)
        for k in numbers:
            yield f"has the opposite sign in {what} {k + 1}", partial(_negated, k, axis)
        for j, k in combinations(numbers, 2):
            order = np.arange(count)
            order[[j, k]] = k, j
            yield f"has {what}s {j + 1} and {k + 1} exchanged", partial(_ordered, order, axis)


def _negated(which: int, axis: int, value: Any) -> Any:
    signs = np.where(np.arange(np.shape(value)[axis]) == which, -1.0, 1.0)
    return np.moveaxis(np.moveaxis(np.asarray(value), axis, -1) * signs, -1, axis)


def _ordered(order: Any, axis: int, value: Any) -> Any:
    return np.take(value, order, axis)


VALUES: dict[str, Callable[[Any], Any]] = {
    "{} has the opposite sign": np.negative,
    "{} is converted to degrees": np.degrees,
    "{} is read as degrees": np.radians,
    "{} counts twice": partial(np.multiply, 2.0),
    "{} counts half": partial(np.multiply, 0.5),
    "{} is ignored, as if it were zero": partial(np.multiply, 0.0),
}


def _other_values(value: Any) -> Iterator[tuple[str, Callable[[Any], Any]]]:
    """What an argument may be taken for."""
    if value.dtype.kind not in "fiu":
        return
    if value.ndim != 1 or len(value) <= SPACE:  # a state is many things, and not one that has a sign
        yield from VALUES.items()
    if value.ndim == 0:
        yield "{} is ignored, as if it were 1", lambda one: 1.0
    if value.ndim == 2 and value.shape[0] == value.shape[1]:
        yield "{} is transposed", np.transpose
    for says, change in _components(value):
        yield f"{{}} {says}", change


def _with_result(which: int, count: int, change: Any, call: Judged) -> Any:
    results = parts(call.right) if count > 1 else [call.right]  # a vector may be a tuple of numbers
    results[which] = change(np.asarray(results[which]), call.case)
    return tuple(results) if count > 1 else results[0]


def _reversed(call: Judged) -> Any:
    return tuple(np.negative(one) for one in parts(call.right))


def _with_product(
    right: Callable[..., Any], taken: Sequence[str], key: str, other: str, power: int, call: Judged
) -> Any:
    values = _named(taken, call.case)
    return right(**{**values, key: np.asarray(values[key]) * float(values[other]) ** power})


def _about_another_point(
    right: Callable[..., Any], taken: Sequence[str], key: str, k: int, length: str, power: int, call: Judged
) -> Any:
    values = _named(taken, call.case)
    inertia = np.array(values[key], float)
    inertia.flat[k] += power * float(values["mass"]) * float(values[length]) ** 2
    return right(**{**values, key: inertia if inertia.ndim else float(inertia)})


def _relabelled(right: Callable[..., Any], taken: Sequence[str], key: str, pair: list[int], call: Judged) -> Any:
    values = _named(taken, call.case)
    order = np.arange(len(values[key]))
    order[pair] = pair[::-1]
    return np.take(right(**{**values, key: np.take(values[key], order)}), order)


def _exchanged(right: Callable[..., Any], taken: Sequence[str], one: str, other: str, call: Judged) -> Any:
    values = _named(taken, call.case)
    return right(**{**values, one: values[other], other: values[one]})


def _named(taken: Sequence[str], case: Case) -> dict[str, Any]:
    return {**dict(zip(taken, case.args, strict=False)), **case.kwargs}
