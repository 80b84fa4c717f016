"""A student's result beside the right one, and whether another wrong answer explains it."""

import functools
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tam570.checking.transforms import parts
from tam570.values import Numbers
from tam570_grader.checks.case import Call, Case
from tam570_grader.checks.motions import flat
from tam570_grader.diagnosis.mistakes import OF_MOTIONS, is_motion, same, tolerance_of

INFORMATIVE = 1e-3  # of the right answer; smaller results may be rounding errors of terms that cancel
CLEARLY = 0.03  # of the size of a column: after an error this large, the later rows of a motion need not be compared
FEW = 3  # rows that are compared of a right motion
SHARE = 8  # the first of this many parts of the rows is compared first
# Of the error of a column: two accurate integrations of one wrong equation differ by less, those of another one with
# similar numbers by more. For a column with less than a tenth of the largest error, a tenth of that is used instead.
EXPLAINED, HARDLY = 3e-4, 0.1


@dataclass(frozen=True)
class ComparedCall(Call):
    """A call, the student's result, and the right answer; size: see `same`."""

    expected: Numbers
    size: float = 1.0

    def fits(self, answer: Numbers) -> bool:
        """Return whether an answer agrees with the student's result; False for None."""
        is_numbers = self.result is not None and answer is not None
        return is_numbers and same(self.result, answer, tolerance_of(self), self.size)

    def numbers(self) -> set[bytes]:
        """Return the results that must be explained, unless they may be rounding errors relative to the right answer.

        Zeros are not informative. A function without arguments has only one call, and each of its results counts; a
        formula has a value at each of many points.
        """
        if self.case.points:
            return {value.tobytes() for value in np.asarray(self.result) if value}
        if not (self.case.args or self.case.kwargs):
            return {np.asarray(part).tobytes() for part in parts(self.result) if np.any(part)}
        result, expected = (np.concatenate([*map(np.ravel, parts(each))]) for each in (self.result, self.expected))
        informative = np.abs(result).max(initial=0.0) > INFORMATIVE * np.abs(expected).max(initial=0.0)
        return {result.tobytes()} if informative else set()


class Rows(ComparedCall):
    """The first rows of a motion, until it is clearly wrong; later rows are no more informative, and take longer."""

    def fits(self, answer: Numbers) -> bool:
        """Return whether an answer explains the error of every column; a nearly right motion must stay so."""
        if answer is None or _shapes(answer) != _shapes(self.expected):
            return False
        return bool((_off(self.result, answer) <= self._left).all())

    @functools.cached_property
    def _left(self) -> Numbers:
        """The largest error (columns,) that an explanation may leave."""
        off = _off(self.result, self.expected).max(axis=0)
        if off.max() <= OF_MOTIONS:
            return OF_MOTIONS
        return np.minimum(OF_MOTIONS, EXPLAINED * np.maximum(off, HARDLY * off.max()))

    def numbers(self) -> set[bytes]:
        return {row.tobytes() for row in flat(self.result)}


class Beginning(ComparedCall):
    """The first rows of a motion, which rule out most variants before more rows must be integrated."""

    def fits(self, answer: Numbers) -> bool:
        return (
            answer is not None and _shapes(answer) == _shapes(self.expected) and same(self.result, answer, OF_MOTIONS)
        )

    def numbers(self) -> set[bytes]:
        return set()


def beginning(call: ComparedCall) -> Beginning | None:
    """Return the first part of the rows of a motion; None if it is short, or not a motion."""
    count = max(FEW, len(call.case.args[0]) // SHARE) if isinstance(call, Rows) else 0
    if not count or count > len(call.case.args[0]) // 2:
        return None
    return Beginning(*_first_rows(call, call.expected, count))


def compared_call(call: Call, expected: Numbers, size: float) -> ComparedCall:
    """Return a call beside the right answer; of a motion, only the informative rows."""
    if not is_motion(call) or _shapes(call.result) != _shapes(expected):
        return ComparedCall(call.name, call.case, call.result, expected, size)
    t, off = call.case.args[0], _off(call.result, expected).max(axis=1)
    clear = np.flatnonzero(off > CLEARLY)
    count = clear[0] + 2 if len(clear) else FEW if off.max() <= OF_MOTIONS else len(t)
    return Rows(*_first_rows(call, expected, count))


def _first_rows(call: Call, expected: Numbers, count: int) -> tuple[str, Case, Numbers, Numbers]:
    """Return the name, case, result and right answer of a motion, cut to its first rows."""
    firsts = [[part[:count] for part in parts(answer)] for answer in (call.result, expected)]
    result, expected = (tuple(first) if len(first) > 1 else first[0] for first in firsts)
    return call.name, call.case.replace(call.case.args[0][:count]), result, expected


def _shapes(answer: Numbers) -> list[tuple[int, ...]]:
    return [np.shape(part) for part in parts(answer)]


def _off(result: Numbers, expected: Numbers) -> NDArray[np.float64]:
    """Return the errors (rows, columns) of a motion, relative to the size of each column; infinite for NaN."""
    result, expected = flat(result), flat(expected)
    size = np.abs(expected).max(axis=0)
    with np.errstate(all="ignore"):
        off = np.abs(result - expected) / np.where(size > 0, size, 1.0)
    return np.where(np.isfinite(off), off, np.inf)
