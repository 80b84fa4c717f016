"""A check that is one comparison, said in one expression.

    energy_is_half_omega_h = law("energy: half of omega . H.", points=0.5, part="a").agrees(
        right.energy, cases.spinning, within=POINTWISE
    )

`one.then("...", points=1, part="a")` is a law that builds on another check; `.also` goes on with the same one, where
cases have limits of their own: `law(...).agrees(...).also.agrees(...)`. A check's name is the one that it is
bound to; the student's function has the name of the right one. Cases are functions of `rng`; those of several are
drawn in turn, and judged together. All else is handed on: see `compare`, `compare_trajectory`, `check_conserved`.
"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from itertools import chain
from typing import Any

import numpy as np

from tam570_grader.checks.case import Case
from tam570_grader.checks.check import Check, needed, once
from tam570_grader.checks.compare import check_raises, compare, compare_columns, trim_to_signature
from tam570_grader.checks.trajectory import Invariant, check_conserved, compare_trajectory

__all__ = ["Law", "law"]

Cases = Callable[[np.random.Generator], Iterable[Any]]  # of Given, but for a judge of one's own
Reference = Callable[..., Any]

LAST = 2  # inputs kept of a law: a class shares them, or no two students do


@dataclass(frozen=True)
class Judged(Check):
    """A check that a law made."""

    def then(self, line: str, *, points: float, part: str) -> "Law":
        """A law that is judged only when this check has (nearly) passed."""
        return law(line, points=points, part=part, after=self)

    @property
    def also(self) -> "Law":
        """The same law, of which more is to be judged, behind what is: `law(...).agrees(...).also.follows(...)`."""
        return Law(self.line, self.points, self.part, self.after, self.judge)


@dataclass(frozen=True)
class Law:
    """What a check is worth, and the line that the student reads."""

    line: str
    points: float
    part: str
    after: Check | Sequence[Check]
    first: Callable[[Any, np.random.Generator], None] | None = None  # what is judged before

    def agrees(self, reference: Reference, *cases: Cases, **known: Any) -> Judged:
        """The student's function gives what the right one gives."""
        return self.judged(
            lambda function, calls: compare(function, reference, calls, **known), reference.__name__, *cases
        )

    def agrees_by_columns(self, reference: Reference, *cases: Cases, **known: Any) -> Judged:
        """The same for states, whose numbers have different units."""

        def judge(function: Any, calls: list[Case]) -> None:
            compare_columns(function, reference, calls, **known)

        return self.judged(judge, reference.__name__, *cases)

    def follows(self, reference: Reference, *cases: Cases, name: str = "", **known: Any) -> Judged:
        """The student's simulation follows the right motion; `name` is its own, if the right one's is another."""
        called = name or reference.__name__
        return self.judged(
            lambda function, calls: compare_trajectory(function, reference, calls, **known), called, *cases
        )

    def keeps(self, *invariants: Invariant, reference: Reference, cases: Cases, name: str = "", **known: Any) -> Judged:
        """The invariants stay along the student's motions, as the right ones show them."""

        called = name or reference.__name__
        return self.judged(
            lambda function, calls: check_conserved(function, reference, calls, *invariants, **known), called, cases
        )

    def refuses(
        self, reference: Reference, *cases: Cases, tolerance: float, allowed: int = 1, hint: str = ""
    ) -> Judged:
        """The student's function raises ValueError, but for the first cases: so many are allowed, and judged."""

        def judge(function: Any, calls: list[Case]) -> None:
            compare(function, reference, calls[:allowed], tolerance=tolerance, hint="This input is allowed")
            check_raises(function, trim_to_signature(reference, calls[allowed:]), hint=hint)

        return self.judged(judge, reference.__name__, *cases)

    def judged(self, judge: Callable[..., object], name: str, *cases: Cases, **known: Any) -> Judged:
        """What `judge(function, calls, **known)` says of the student's function of this name."""
        first = self.first
        inputs = once(lambda rng: list(chain.from_iterable(drawn(rng) for drawn in cases)), most=LAST)

        def judged(student: Any, rng: np.random.Generator) -> None:
            if first:
                first(student, rng)
            judge(getattr(student, name), inputs(rng), **known)

        judged.__doc__ = self.line
        return Judged(judged, float(self.points), self.part, needed(self.after))


def law(line: str, *, points: float, part: str, after: Check | Sequence[Check] = ()) -> Law:
    """A check worth `points` in a lettered part, run only when all of `after` have (nearly) passed."""
    return Law(line, points, part, after)
