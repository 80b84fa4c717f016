"""Compare a student's function with the reference function, over cases."""

import functools
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from inspect import Parameter, signature
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tam570.values import Function, Numbers
from tam570_grader.checks.case import Case
from tam570_grader.checks.check import LruCache
from tam570_grader.checks.expect import Failed, NotWritten, distance, expect, expect_that, fail, get_context
from tam570_grader.checks.expected import expected_result
from tam570_grader.checks.returns import Scale
from tam570_grader.checks.student import StudentFunction


@dataclass(frozen=True)
class Column:
    """Components of a result, or columns of a motion, that share a unit and a scale."""

    quantity: str  # "the angles"
    unit: str
    where: slice | Sequence[int]
    turns: bool = False  # angles, which are never wrapped
    scale: Callable[[Case, Numbers], float] | None = None  # scale(case, right result); default: the largest number

    def size(self, case: Case, expected: NDArray[np.float64]) -> Numbers:
        """Return the scale of an error; 1 if that is zero."""
        return (self.scale(case, expected) if self.scale else np.max(np.abs(expected[..., self.where]))) or 1.0


PLACES = range(2, 13)  # decimals to which students may round; a number with two or fewer may be exact
PERCENT = 0.01  # of a number: the error of a poor quadrature is smaller, that of wrong physics mostly larger
NEARLY = 1e-4  # of the largest number: the error of a wrong term is larger, that of a loose tolerance smaller
SINGLE = 1e-6  # of the largest number; the rounding error of single precision is 6e-8

MOST_BATCHES = 1000  # in the cache; the fourteen assignments have some 600

Array = NDArray[np.float64]
Only = int | Sequence[int] | None
Shapes = Sequence[tuple[int, ...]]
Where = int | tuple[Any, ...] | None  # a member of a tuple, columns, or None for all
Reference = Function | ModuleType
HintOfCase = str | Callable[[Case, Numbers, Numbers], str]  # or hint(case, result, expected result)


@dataclass(frozen=True)
class Comparison:
    """Numbers of a result that are compared together, with the expected ones."""

    actual: Numbers
    expected: Numbers
    quantity: str
    unit: str
    size: Numbers  # scale of an error
    member: int | None = None  # index in a tuple
    columns: Sequence[int] | None = None
    t: Numbers = None  # times of the rows

    @property
    def where(self) -> Where:
        """The index of these numbers in the result."""
        return self.member if self.columns is None else (..., self.columns)


Comparisons = Callable[[Case, Numbers, Numbers], Iterable[Comparison]]  # (case, result, expected result)


def compare(  # noqa: PLR0913  options of a comparison, passed by name
    function: StudentFunction,
    reference: Reference,
    cases: Iterable[Case],
    *,
    tolerance: float,
    scale: Scale | None = None,
    columns: Sequence[Column] = (),
    hint: HintOfCase = "",
    partial: Mapping[float, float] | None = None,
    only: Only = None,
    near_miss_credit: bool = True,
) -> list[Numbers]:
    """Fail unless the student's `function` returns what `reference` returns, in every case; return its results.

    reference : the reference function, or a module that has it under the name of the student's
    tolerance : largest error relative to the scale, which by default is the largest number of the expected result
    scale  : default: that in `Assignment.returns`
    columns : of a state or rows of states, each compared in its own unit; default: those in `Assignment.returns`
    hint   : where to look; a function of the case, the result and the expected one is called only on failure
    only   : the index of the member of a tuple that is compared, or several
    near_miss_credit : False if an error of a few tolerances is no sign that the physics is right
    """
    batch = Batch.of(find_reference(reference, function), cases).distinct
    if columns := columns or getattr(function.returns, "columns", ()):
        parts, key = functools.partial(_by_columns, columns), ("columns", *map(id, columns))
    else:
        descriptions = function.returns.description
        each = descriptions if isinstance(descriptions, list) else [descriptions]
        scales = [scale or description.scale or largest for description in each]
        parts, key = functools.partial(_by_members, descriptions, scales, only), (str(only), *scales)
    results = batch.results(function)
    if not get_context().listens and batch.includes(results, tolerance, key, parts):
        return results
    for case, result, expected in batch.compared(function, results):
        for part in parts(case, result, expected):
            ask = functools.partial(_hint, hint, case, result, expected, part)
            words = {"quantity": part.quantity, "scale": part.size, "tolerance": tolerance}
            get_context().add_example(function, case, part.member, part.columns, part.expected, **words)
            few_or_many = "many" if np.size(part.actual) > np.size(part.expected) else "few"
            has_shape = np.shape(part.actual) == np.shape(part.expected)
            expect_that(has_shape, f"{part.quantity}: you return too {few_or_many} numbers")
            infinite, must_be = np.isinf(part.actual), np.isinf(part.expected)  # no tolerance applies to infinity
            message = f"{part.quantity} is {'not ' if must_be.any() else ''}infinite"
            expect_that(np.array_equal(infinite, must_be), message, hint=ask)
            limits = _limits(part.size, tolerance, partial or {}) | {"near_miss_credit": near_miss_credit}
            expect(part.actual, part.expected, quantity=part.quantity, unit=part.unit, t=part.t, hint=ask, **limits)
    return results


def _by_members(
    descriptions: Any, scales: Sequence[Scale], only: Only, case: Case, actual: Numbers, expected: Numbers
) -> Iterator[Comparison]:
    """Yield the comparison of the result, or of each member of a tuple that is compared."""
    several = isinstance(descriptions, list)
    members = zip(descriptions, actual, expected, strict=True) if several else [(descriptions, actual, expected)]
    for index, (description, numbers, right_numbers) in enumerate(members):
        if only is None or index in np.atleast_1d(only):
            size = scales[index](case, right_numbers)
            size = np.where(np.asarray(size) == 0, 1.0, size) if np.ndim(size) else size or 1.0
            words = description.quantity, description.unit
            yield Comparison(numbers, right_numbers, *words, size, index if several else None)


def _by_columns(columns: Sequence[Column], case: Case, actual: Numbers, expected: Numbers) -> Iterator[Comparison]:
    actual, expected = np.asarray(actual, float), np.asarray(expected, float)
    t = case.args[0] if actual.ndim == 2 else None
    for column in columns:
        where = np.arange(expected.shape[-1])[column.where].tolist()
        words = column.quantity, column.unit, column.size(case, expected)
        yield Comparison(actual[..., where], expected[..., where], *words, columns=where, t=t)


def if_nearly(accuracy: HintOfCase, otherwise: str) -> HintOfCase:
    """Return a hint for a positive number: a question about its accuracy if it is nearly right, else `otherwise`."""

    def hint(case: Case, number: Numbers, expected: Numbers) -> str:
        if not abs(number - expected) <= PERCENT * expected:
            return otherwise
        return f"It is nearly right{accuracy(case, number, expected) if callable(accuracy) else f': {accuracy}'}"

    return hint


def compare_with(
    reference: Reference, *, by: Callable[..., Any] = compare, **defaults: Any
) -> Callable[..., list[Numbers]]:
    """Return `by` with its reference, and with defaults for the options that a check does not pass.

    compare = compare_with(reference, tolerance=FORMULA)
    compare_motions = compare_with(reference, by=compare_trajectory, tolerance=TRAJECTORY)
    compare(student.energy, cases.states(rng), hint="Which three terms?")
    """

    def compare_cases(function: StudentFunction, cases: Iterable[Case], *more: Any, **words: Any) -> list[Numbers]:
        results: list[Numbers] = by(function, reference, cases, *more, **{**defaults, **words})
        return results

    return compare_cases


def _limits(size: Numbers, tolerance: float, partial: Mapping[float, float]) -> dict[str, Numbers]:
    """Return the limits in the unit of the result; if its numbers have several scales, relative to these."""
    if np.ndim(size):
        return {"tolerance": tolerance, "scale": size, "partial": partial}
    size = float(size)
    return {"tolerance": tolerance * size, "partial": {limit * size: share for limit, share in partial.items()}}


def absolute(*_: Numbers) -> float:
    """Return 1, the scale of errors in the unit of the result."""
    return 1.0


def largest(_: Numbers, expected: Numbers) -> float:
    """Return the largest number of the expected result: the default scale."""
    return float(np.max(np.abs(np.asarray(expected, float)), initial=0.0))


@dataclass(frozen=True)
class Batch:
    """Cases, trimmed to the parameters of the reference function, with their expected results; shared by students."""

    reference: Function
    uncut: Sequence[Case]  # kept, so that no other case gets an id that is a key of `_batches`
    _known: dict[object, Numbers] = field(default_factory=dict)

    @staticmethod
    def of(reference: Function, cases: Iterable[Case]) -> "Batch":
        """Return the batch of these Case objects, which are identified by id."""
        uncut = tuple(cases)
        return _batches.value((reference, *map(id, uncut)), lambda: Batch(reference, uncut))

    @functools.cached_property
    def cases(self) -> list[Case]:
        return [_trimmed(self.reference, case) for case in self.uncut]

    @functools.cached_property
    def distinct(self) -> "Batch":
        """The batch without cases that trimming makes equal to an earlier one."""
        first: dict[bytes, Case] = {}
        for cut, case in zip(self.cases, self.uncut, strict=True):
            first.setdefault(cut.packed, case)
        pairs = zip(self.cases, self.uncut, strict=True)
        cases = [case for cut, case in pairs if cut is case or first[cut.packed] is case]
        return self if len(cases) == len(self.uncut) else Batch(self.reference, cases)

    @functools.cached_property
    def expected(self) -> list[Numbers]:
        return [expected_result(self.reference, case) for case in self.cases]

    def results(self, function: StudentFunction) -> list[Numbers]:
        """Return the results of the student's function in all cases; the expected ones in a rehearsal."""
        return self.expected if get_context().is_rehearsal else function.many(self.cases)

    def remembered(self, key: object, compute: Callable[[], Numbers]) -> Numbers:
        """Return a value that depends only on the cases and the expected results; cached by key."""
        if key not in self._known:
            self._known[key] = compute()
        return self._known[key]

    def compared(
        self, function: StudentFunction, results: Iterable[Numbers]
    ) -> Iterator[tuple[Case, Numbers, Numbers]]:
        """Yield each case with the student's result and the expected one, and make it the call of the context."""
        for case, result, expected in zip(self.cases, results, self.expected, strict=True):
            get_context().set_call(function.name, case)
            yield case, result, expected

    def includes(self, results: list[Numbers], tolerance: float, key: object, parts: Comparisons) -> bool:
        """Return whether all results are within the tolerance; False if this needs a comparison of each result.

        parts : (case, result, expected result) -> the comparisons
        key   : identifies `parts`
        """
        # `parts` is cached, too, so that the ids in the key stay in use
        _, scaled = self.remembered(key, lambda: (parts, self._scales(parts)))
        for where, shapes, numbers, sizes in scaled or ():
            compared = [_part(result, where) for result in results]
            if [getattr(part, "shape", ()) for part in compared] != shapes:
                return False
            if not (distance(_flat(compared, shapes), numbers) <= tolerance * sizes).all():
                return False
        return scaled is not None

    def _scales(self, parts: Comparisons) -> list[tuple[Numbers, ...]] | None:
        """Return (where, shapes, expected numbers, their scales) for each part; None if a number is not finite."""
        per_case = [[*parts(case, answer, answer)] for case, answer in zip(self.cases, self.expected, strict=True)]
        scaled = []
        for column in zip(*per_case, strict=True):
            expected = [np.asarray(part.expected, float) for part in column]
            shapes = [part.shape for part in expected]
            numbers = _flat(expected, shapes)
            if not np.isfinite(numbers).all():
                return None
            sizes = [np.broadcast_to(part.size, shape) for part, shape in zip(column, shapes, strict=True)]
            scaled.append((column[0].where, shapes, numbers, _flat(sizes, shapes)))
        return scaled


def _part(result: Numbers, where: Where) -> Numbers:
    if where is None or isinstance(where, int):
        return result if where is None else result[where]
    return np.asarray(result, float)[where]  # in a rehearsal it may be a tuple


def _flat(values: Sequence[Numbers], shapes: Shapes) -> Array:
    return np.array(values).ravel() if len(set(shapes)) == 1 else np.concatenate([np.ravel(value) for value in values])


_batches = LruCache[Batch](MOST_BATCHES)


def call_cases(
    function: StudentFunction, reference: Reference, cases: Iterable[Case]
) -> Iterator[tuple[Case, Numbers, Numbers]]:
    """Yield each case, trimmed to the reference's parameters, with the student's result and the expected one."""
    batch = Batch.of(find_reference(reference, function), cases).distinct
    yield from batch.compared(function, batch.results(function))


def is_right(function: StudentFunction, reference: Reference, cases: Iterable[Case]) -> bool:
    """Return whether a student's function is right in calls that no check grades, to choose a hint."""
    true = find_reference(reference, function)
    try:
        for case in trim_to_signature(true, cases):
            expected = _numbers(expected_result(true, case))
            off = np.abs(_numbers(function.aside(case)) - expected)
            if not off.max(initial=0.0) <= NEARLY * (largest(case, expected) or 1.0):
                return False
        return True
    except (Failed, NotWritten):
        return False


def own_result(function: StudentFunction, reference: Reference, case: Case) -> Numbers:
    """Return a student's result for a case, trimmed to the reference's parameters, in a call that no check grades."""
    return function.aside(trim_to_signature(find_reference(reference, function), [case])[0])


def first_wrong(reference: Reference, case: Case, *functions: StudentFunction) -> Callable[[], str]:
    """Return a callback that names the first of a student's functions that is wrong for a case; "" if none is."""
    return lambda: next((function.name for function in functions if not is_right(function, reference, [case])), "")


def _numbers(result: Numbers) -> Numbers:
    """Return all numbers of a result, or of the members of a tuple, in one array."""
    return np.hstack([np.ravel(part) for part in (result if isinstance(result, tuple) else [result])])


def find_reference(reference: Reference, function: StudentFunction) -> Function:
    """Return the reference function; from a module, the one with the name of the student's function."""
    true: Function = reference if callable(reference) else getattr(reference, function.name)
    return true


def trim_to_signature(reference: Function, cases: Iterable[Case]) -> list[Case]:
    """Return cases trimmed to the reference's parameters, so that functions with fewer parameters can use them."""
    return Batch.of(reference, cases).cases


def _trimmed(reference: Function, case: Case) -> Case:
    kinds = {name: parameter.kind for name, parameter in _signature(reference).parameters.items()}
    takes_any = Parameter.VAR_KEYWORD in kinds.values()
    kwargs = {name: value for name, value in case.kwargs.items() if takes_any or name in kinds}
    count = sum(kind is Parameter.POSITIONAL_OR_KEYWORD for name, kind in kinds.items() if name not in kwargs)
    args = case.args if Parameter.VAR_POSITIONAL in kinds.values() else case.args[:count]
    is_uncut = len(args) == len(case.args) and len(kwargs) == len(case.kwargs)
    return case if is_uncut else Case(*args, **kwargs).labelled(case.label, case.hint)


_signature = functools.lru_cache(maxsize=256)(signature)


def _hint(hint: HintOfCase, case: Case, actual: Numbers, expected: Numbers, part: Comparison) -> str:
    """Return a sentence on lost digits, if right numbers lack some; else the hint of the case, or of the check."""
    lost = digits_lost(part.actual, part.expected)
    return lost or case.hint or (hint(case, actual, expected) if callable(hint) else hint)


def digits_lost(actual: Numbers, expected: Numbers) -> str:
    """Return a sentence if right numbers are rounded or in single precision; else an empty text."""
    actual, expected = np.asarray(actual, float), np.asarray(expected, float)
    off = float(np.max(np.abs(actual - expected), initial=0.0))
    exact = [places for places in PLACES if np.array_equal(actual, np.round(actual, places))]
    if exact and exact[0] != PLACES[0] and off <= 10.0 ** -exact[0]:
        return f"The numbers are rounded to {exact[0]} places: return all digits"
    if not exact and off <= SINGLE * np.max(np.abs(expected)) and np.array_equal(actual, actual.astype(np.float32)):
        return "The numbers are in single precision: use float64"
    return ""


def check_raises(function: StudentFunction, cases: Iterable[Case], *, hint: str = "") -> None:
    """Fail unless the function raises ValueError in every case."""
    for case, refused in function.refusals(cases):
        get_context().add_example(function, case, None, None, None, raises=True)
        if not refused:
            fail(f"{function.name} does not raise ValueError", label=case.label, hint=hint, at=case)


def check_domain(
    function: StudentFunction,
    reference: Reference,
    cases: Sequence[Case],
    *,
    tolerance: float,
    allowed: int = 1,
    hint: str = "",
) -> None:
    """Fail unless the function is right in the first `allowed` cases, and raises ValueError in all others.

    If a check before this one found wrong numbers, require only that the function does not raise in allowed cases.
    """
    trimmed = trim_to_signature(find_reference(reference, function), cases)
    function = function.ahead(trimmed)
    if get_context().wrong_before:
        for case, refused in function.refusals(trimmed[:allowed]):
            if refused:
                fail(f"{function.name} raises ValueError", label=case.label, hint="This input is allowed", at=case)
    else:
        compare(function, reference, trimmed[:allowed], tolerance=tolerance, hint="This input is allowed")
    check_raises(function, trimmed[allowed:], hint=hint)
