"""What `solve` returns when more is asked for than states: events, a function of time, a report."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

from numpy.typing import ArrayLike

from tam570.integrate.arguments import Array

__all__ = ["Crossing", "Motion", "Report"]


@dataclass(frozen=True)
class Report:
    """How a run went.

    engine          : "Python" or "compiled"
    untraced_reason : why the right-hand side was called as it stands instead of traced; empty if it was traced
    steps           : taken
    refusals        : steps that were too long and taken again
    evaluations     : of the right-hand side by these steps, twelve each; None where compiled series took their place
    atol            : (k,) the error allowed in any case; where the caller gave none, what follows from the start
    """

    engine: str
    untraced_reason: str
    steps: int
    refusals: int
    evaluations: int | None
    atol: Array


class Crossing(NamedTuple):
    """Where one event function passed zero: times (c,) and states (c, k), in the order of the run."""

    t: Array
    states: Array


@dataclass(frozen=True)
class Motion:
    """A motion with what was asked for.

    t      : (n,) the times asked for, those up to a terminal event
    states : (n, k)
    events : one `Crossing` for each event function
    at     : at(time or times) -> (k,) or (n, k) states, where `dense` was asked for; else None
    report : `Report`
    """

    t: Array
    states: Array
    events: tuple[Crossing, ...]
    at: Callable[[ArrayLike], Array] | None
    report: Report
