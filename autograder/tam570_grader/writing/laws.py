"""A check that is one comparison, said in one expression.

    energy_is_half_omega_h = law("energy: half of omega . H.", points=0.5, part="a").agrees(
        right.energy, cases.spinning, within=POINTWISE
    )

`one.then("...", points=1, part="a")` is a law that builds on another check; `.also` goes on with the same one, where
cases have limits of their own: `law(...).agrees(...).also.agrees(...)`. A check's name is the one that it is
bound to; the student's function has the name of the right one. Cases are functions of `draw`; those of several are
drawn in turn, and judged together. All else is handed on: see `agree`, `follow`, `stays`.
"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from itertools import chain
from typing import Any

import numpy as np

from tam570_grader.writing.agree import agree, agree_by_columns, refuse, taken
from tam570_grader.writing.check import Check, Given, needed, once
from tam570_grader.writing.follow import Invariant, follow, stays

__all__ = ["Law", "law"]

Cases = Callable[[np.random.Generator], Iterable[Any]]  # of Given, but for a judge of one's own
Right = Callable[..., Any]

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

    def agrees(self, right: Right, *cases: Cases, **known: Any) -> Judged:
        """The student's function gives what the right one gives."""
        return self.judged(lambda function, calls: agree(function, right, calls, **known), right.__name__, *cases)

    def agrees_by_columns(self, right: Right, *cases: Cases, **known: Any) -> Judged:
        """The same for states, whose numbers have different units."""

        def judge(function: Any, calls: list[Given]) -> None:
            agree_by_columns(function, right, calls, **known)

        return self.judged(judge, right.__name__, *cases)

    def follows(self, right: Right, *cases: Cases, name: str = "", **known: Any) -> Judged:
        """The student's simulation follows the right motion; `name` is its own, if the right one's is another."""
        called = name or right.__name__
        return self.judged(lambda function, calls: follow(function, right, calls, **known), called, *cases)

    def keeps(self, *invariants: Invariant, right: Right, cases: Cases, name: str = "", **known: Any) -> Judged:
        """The invariants stay along the student's motions, as the right ones show them."""

        called = name or right.__name__
        return self.judged(lambda function, calls: stays(function, right, calls, *invariants, **known), called, cases)

    def refuses(self, right: Right, *cases: Cases, within: float, allowed: int = 1, hint: str = "") -> Judged:
        """The student's function raises ValueError, but for the first cases: so many are allowed, and judged."""

        def judge(function: Any, calls: list[Given]) -> None:
            agree(function, right, calls[:allowed], within=within, hint="This input is allowed")
            refuse(function, taken(right, calls[allowed:]), hint=hint)

        return self.judged(judge, right.__name__, *cases)

    def judged(self, judge: Callable[..., object], name: str, *cases: Cases, **known: Any) -> Judged:
        """What `judge(function, calls, **known)` says of the student's function of this name."""
        first = self.first
        inputs = once(lambda draw: list(chain.from_iterable(drawn(draw) for drawn in cases)), most=LAST)

        def judged(student: Any, draw: np.random.Generator) -> None:
            if first:
                first(student, draw)
            judge(getattr(student, name), inputs(draw), **known)

        judged.__doc__ = self.line
        return Judged(judged, float(self.points), self.part, needed(self.after))


def law(line: str, *, points: float, part: str, after: Check | Sequence[Check] = ()) -> Law:
    """A check worth `points` in a lettered part, run only when all of `after` have (nearly) passed."""
    return Law(line, points, part, after)
