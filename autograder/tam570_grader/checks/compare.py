"""A student's function against the right one, over cases."""

import functools
import inspect
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
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
    """Numbers of a result, or columns of a motion, that share a unit and a scale."""

    quantity: str  # "the angles"
    unit: str
    where: slice | Sequence[int]
    turns: bool = False  # angles, which are never wrapped
    scale: Callable[[Case, Numbers], float] | None = None  # scale(case, right result); default: the largest number

    def size(self, case: Case, expected: NDArray[np.float64]) -> Numbers:
        """Return what an error is relative to; 1 where that is zero."""
        return (self.scale(case, expected) if self.scale else np.max(np.abs(expected[..., self.where]))) or 1.0


PLACES = range(2, 13)  # after the point, to which people round; what has two or fewer may be exact
PLACED, ARGUMENTS, KEYWORDS = (  # f(name, *args, **known)
    inspect.Parameter.POSITIONAL_OR_KEYWORD,
    inspect.Parameter.VAR_POSITIONAL,
    inspect.Parameter.VAR_KEYWORD,
)
NEARLY = 1e-4  # of the largest number: a wrong term is off by more, a simulation at a loose tolerance by less
SINGLE = 1e-6  # of the largest number; single precision loses 6e-8

MOST_BATCHES = 1000  # that are remembered; the fourteen assignments have some 600

Array = NDArray[np.float64]
Only = int | Sequence[int] | None
Shapes = Sequence[tuple[int, ...]]
Where = int | tuple[Any, ...] | None  # a member of a tuple, columns, or all
Reference = Function | ModuleType
HintOfCase = str | Callable[[Case, Numbers, Numbers], str]  # of a case, the result and the right one


@dataclass(frozen=True)
class Comparison:
    """Numbers of a result that are compared at once, beside the right ones."""

    actual: Numbers
    expected: Numbers
    quantity: str
    unit: str
    size: Numbers  # what an error is relative to
    member: int | None = None  # of a tuple
    columns: Sequence[int] | None = None
    t: Numbers = None  # times of its rows

    @property
    def where(self) -> Where:
        """Where the result has these numbers."""
        return self.member if self.columns is None else (..., self.columns)


Comparisons = Callable[[Case, Numbers, Numbers], Iterable[Comparison]]  # of a case, the result and the right one


def compare(  # noqa: PLR0913  what a check says of a comparison, each by its name
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
    """Fail unless the student's `function` gives what `reference` gives, in every case; return its results.

    reference : the right function, or the module in which it has the name of the student's
    tolerance : of the scale, by default the largest number of the right result
    scale  : left out, as `Assignment.returns` has it
    columns : of a state or rows of them, each judged in its own unit; left out, as `Assignment.returns` has them
    hint   : where to look; a function of the case, the result and the right one is asked on failure alone
    only   : the member of a tuple that is judged, or several
    near_miss_credit : False where an error of a few limits is no sign that the physics is right
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
            infinite, must_be = np.isinf(part.actual), np.isinf(part.expected)  # nothing is wrong by some limit
            message = f"{part.quantity} is {'not ' if must_be.any() else ''}infinite"
            expect_that(np.array_equal(infinite, must_be), message, hint=ask)
            limits = _limits(part.size, tolerance, partial or {}) | {"near_miss_credit": near_miss_credit}
            expect(part.actual, part.expected, quantity=part.quantity, unit=part.unit, t=part.t, hint=ask, **limits)
    return results


def _by_members(
    descriptions: Any, scales: Sequence[Scale], only: Only, case: Case, actual: Numbers, expected: Numbers
) -> Iterator[Comparison]:
    """Yield the result, or the members of a tuple that are judged."""
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


def compare_with(
    reference: Reference, *, by: Callable[..., Any] = compare, **defaults: Any
) -> Callable[..., list[Numbers]]:
    """Return a comparison with its reference, and with words that hold where a check has no others.

    compare = compare_with(reference, tolerance=FORMULA)
    compare_motions = compare_with(reference, by=compare_trajectory, tolerance=TRAJECTORY)
    compare(student.energy, cases.states(rng), hint="Which three terms?")
    """

    def compare_cases(function: StudentFunction, cases: Iterable[Case], *more: Any, **words: Any) -> list[Numbers]:
        results: list[Numbers] = by(function, reference, cases, *more, **{**defaults, **words})
        return results

    return compare_cases


def _limits(size: Numbers, tolerance: float, partial: Mapping[float, float]) -> dict[str, Numbers]:
    """In the unit of the result; where its numbers have scales of their own, relative to these."""
    if np.ndim(size):
        return {"tolerance": tolerance, "scale": size, "partial": partial}
    size = float(size)
    return {"tolerance": tolerance * size, "partial": {limit * size: share for limit, share in partial.items()}}


def absolute(*_: Numbers) -> float:
    """Return the scale of what is judged in its own unit."""
    return 1.0


def largest(_: Numbers, expected: Numbers) -> float:
    """Return the scale of what is judged by its largest number, as all is that has no other scale."""
    return float(np.max(np.abs(np.asarray(expected, float)), initial=0.0))


@dataclass(frozen=True)
class Batch:
    """Cases, cut to what the right function takes, with the right results: the same for a class."""

    reference: Function
    uncut: Sequence[Case]  # while they are held, no other case has their identity
    _known: dict[object, Numbers] = field(default_factory=dict)

    @staticmethod
    def of(reference: Function, cases: Iterable[Case]) -> "Batch":
        """Return the batch of these very cases."""
        uncut = tuple(cases)
        return _batches.value((reference, *map(id, uncut)), lambda: Batch(reference, uncut))

    @functools.cached_property
    def cases(self) -> list[Case]:
        return [_trimmed(self.reference, case) for case in self.uncut]

    @functools.cached_property
    def distinct(self) -> "Batch":
        """Of cases that the cut makes equal, the first alone."""
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
        """Return what the student's function gives in all cases; in a rehearsal what is right."""
        return self.expected if get_context().is_rehearsal else function.many(self.cases)

    def remembered(self, key: object, compute: Callable[[], Numbers]) -> Numbers:
        """Return what follows from the cases and the right results alone, computed a single time."""
        if key not in self._known:
            self._known[key] = compute()
        return self._known[key]

    def compared(
        self, function: StudentFunction, results: Iterable[Numbers]
    ) -> Iterator[tuple[Case, Numbers, Numbers]]:
        """Yield each case with the student's result and the right one, while the two are compared."""
        for case, result, expected in zip(self.cases, results, self.expected, strict=True):
            get_context().set_call(function.name, case)
            yield case, result, expected

    def includes(self, results: list[Numbers], tolerance: float, key: object, parts: Comparisons) -> bool:
        """Return whether all results are within the tolerance; False where that takes a look at each.

        parts : of a case, a result and the right one, all that is judged
        key   : tells it from other such functions
        """
        # with the function, which holds what the key identifies
        _, scaled = self.remembered(key, lambda: (parts, self._scales(parts)))
        for where, shapes, numbers, sizes in scaled or ():
            compared = [_part(result, where) for result in results]
            if [getattr(part, "shape", ()) for part in compared] != shapes:
                return False
            if not (distance(_flat(compared, shapes), numbers) <= tolerance * sizes).all():
                return False
        return scaled is not None

    def _scales(self, parts: Comparisons) -> list[tuple[Numbers, ...]] | None:
        """(where, shapes of the right results, their numbers, the scale of each); None where one is infinite."""
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
    """Yield each case, cut to what the right function takes, with the student's result and the right one."""
    batch = Batch.of(find_reference(reference, function), cases).distinct
    yield from batch.compared(function, batch.results(function))


def is_right(function: StudentFunction, reference: Reference, cases: Iterable[Case]) -> bool:
    """Whether a student's function gives the right results in calls that no check judges, to choose a hint by."""
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
    """Return what a student's function gives for as much of a case as it takes, in a call that no check judges."""
    return function.aside(trim_to_signature(find_reference(reference, function), [case])[0])


def first_wrong(reference: Reference, case: Case, *functions: StudentFunction) -> Callable[[], str]:
    """Make a question for the first of a student's functions that is wrong for a case: its name, or ""."""
    return lambda: next((function.name for function in functions if not is_right(function, reference, [case])), "")


def _numbers(result: Numbers) -> Numbers:
    """Return all numbers of a result, or of the members of a tuple, one after another."""
    return np.hstack([np.ravel(part) for part in (result if isinstance(result, tuple) else [result])])


def find_reference(reference: Reference, function: StudentFunction) -> Function:
    """Return the right function; of a module, the one that has the name of the student's."""
    true: Function = reference if callable(reference) else getattr(reference, function.name)
    return true


def trim_to_signature(reference: Function, cases: Iterable[Case]) -> list[Case]:
    """Trim cases to what the right function takes: so the same ones serve functions that are given more or less."""
    return Batch.of(reference, cases).cases


def _trimmed(reference: Function, case: Case) -> Case:
    parameters = _signature(reference).parameters
    kinds = [parameter.kind for parameter in parameters.values()]
    kwargs = {name: case.kwargs[name] for name in case.kwargs if name in parameters or KEYWORDS in kinds}
    count = sum(name not in kwargs and parameter.kind is PLACED for name, parameter in parameters.items())
    args = case.args if ARGUMENTS in kinds else case.args[:count]
    is_uncut = len(args) == len(case.args) and len(kwargs) == len(case.kwargs)
    return case if is_uncut else Case(*args, **kwargs).labelled(case.label, case.hint)


_signature = functools.lru_cache(maxsize=256)(inspect.signature)


def _hint(hint: HintOfCase, case: Case, actual: Numbers, expected: Numbers, part: Comparison) -> str:
    """Return what right numbers have lost, else the hint of the case, else that of the check."""
    lost = digits_lost(part.actual, part.expected)
    return lost or case.hint or (hint(case, actual, expected) if callable(hint) else hint)


def digits_lost(actual: Numbers, expected: Numbers) -> str:
    """Return a sentence for the right numbers in single precision, or rounded, where their digits tell."""
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

    Where a check before this one has found its numbers wrong, it is enough that it gives some for what is allowed.
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
