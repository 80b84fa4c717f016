"""Find students who share a wrong result, equal to twelve digits, that no known mistake explains.

Known mistakes and near misses (errors of a solver at a loose tolerance) do not count, as many students make them.
Numbers that may agree by chance do not, either: zeros, NaN, few digits, and simple multiples of pi and roots.
"""

import hashlib
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from tam570_grader.checks.failure import Failure
from tam570_grader.results.records import Result

DIGITS = 12
FEW = 5  # numbers with at most this many digits may agree by chance
UNITS = (np.pi, np.sqrt(2), np.sqrt(3), np.sqrt(5), np.e)  # simple multiples of these may agree by chance
LARGEST = 12  # largest numerator and denominator of a simple multiple
Sign = tuple[str, str, int, bytes]  # assignment, check, seed, digest of the numbers


@dataclass(frozen=True)
class Shared:
    """Students who have the same wrong numbers in some checks of an assignment."""

    slug: str
    students: tuple[str, ...]
    checks: tuple[str, ...]


def groups(signs: Mapping[tuple[str, str], Iterable[Sign]]) -> list[Shared]:
    """Return the groups of students with equal signs; `signs` has those of each student and assignment."""
    who = defaultdict[Sign, list[str]](list)
    for (student, _), each in sorted(signs.items()):
        for sign in each:
            who[sign].append(student)
    checks = defaultdict[tuple[str, tuple[str, ...]], list[str]](list)
    for (slug, check, *_), names in who.items():
        if len(names) > 1:
            checks[slug, tuple(names)].append(check)
    return [Shared(slug, names, tuple(failed)) for (slug, names), failed in sorted(checks.items())]


def signs_of(result: Result) -> Iterator[Sign]:
    """Yield the sign of each check's wrong result that no known mistake explains."""
    for check in result.checks:
        failure = check.failure
        unknown = failure and not (check.suspect or failure.suspect or failure.follows_from or failure.near_miss)
        if unknown and (digest := _digest(failure)):
            yield result.assignment, check.name, result.seed, digest


def _digest(failure: Failure | None) -> bytes:
    """Return a digest of the student's numbers to twelve digits; b"" if they may agree by chance."""
    if failure is None or failure.actual is None:
        return b""
    try:
        numbers = np.ravel(np.asarray(failure.actual, float))
    except (TypeError, ValueError):
        return b""
    finite = numbers[np.isfinite(numbers)]
    if all(_is_trivial(float(number)) for number in finite):
        return b""
    text = " ".join(f"{number:.{DIGITS - 1}e}" for number in numbers)
    return hashlib.blake2b(text.encode(), digest_size=16).digest()


def _is_trivial(number: float) -> bool:
    """Return whether a number may agree by chance: it has few digits, or is a simple multiple of one of UNITS."""
    if float(f"{number:.{FEW}g}") == number:
        return True
    for unit in UNITS:
        simple = Fraction(number / unit).limit_denominator(LARGEST)
        if 0 < abs(simple.numerator) <= LARGEST and abs(float(simple) * unit - number) < 1e-12 * abs(number):
            return True
    return False
