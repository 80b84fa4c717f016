"""Who shares a wrong result that no known mistake explains: the same numbers to twelve digits.

Known mistakes are made by many, and so are the errors of one solver at one loose tolerance: neither counts. Nor do
numbers that anybody may come by: zeros, NaN, numbers of few digits, and simple multiples of pi and roots.
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
FEW = 5  # digits that a number may have by chance
UNITS = (np.pi, np.sqrt(2), np.sqrt(3), np.sqrt(5), np.e)  # of numbers that anybody may write
LARGEST = 12  # of the numerator and the denominator of a simple multiple
Sign = tuple[str, str, int, bytes]  # assignment, check, seed, digest of the numbers


@dataclass(frozen=True)
class Shared:
    """Students with the same wrong numbers in some checks."""

    slug: str
    students: tuple[str, ...]
    checks: tuple[str, ...]


def groups(signs: Mapping[tuple[str, str], Iterable[Sign]]) -> list[Shared]:
    """Return those who share, with the checks in which they do, of the signs of each student and assignment."""
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
    """Yield what tells a wrong result that no known mistake explains, of each check."""
    for check in result.checks:
        failure = check.failure
        unknown = failure and not (check.suspect or failure.suspect or failure.follows_from or failure.near_miss)
        if unknown and (digest := _digest(failure)):
            yield result.assignment, check.name, result.seed, digest


def _digest(failure: Failure | None) -> bytes:
    """Return a digest of the numbers to twelve digits; b"" where they tell nothing."""
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
    """Return whether anybody may come by a number: it has few digits, or is a simple multiple of pi or a root."""
    if float(f"{number:.{FEW}g}") == number:
        return True
    for unit in UNITS:
        simple = Fraction(number / unit).limit_denominator(LARGEST)
        if 0 < abs(simple.numerator) <= LARGEST and abs(float(simple) * unit - number) < 1e-12 * abs(number):
            return True
    return False
