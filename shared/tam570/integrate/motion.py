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

    Parameters
    ----------
    engine : str
        "Python" or "compiled".
    untraced_reason : str
        Why the right-hand side was called unchanged instead of traced; empty if it was traced.
    unseen_reason : str
        Why nobody can see where such a function switches; its steps are then at most a thousandth of the run.
    steps : int
    refusals : int
        Steps that were too long and were repeated.
    evaluations : int or None
        Of the right-hand side in these steps, twelve each; None if compiled series replaced them.
    atol : (k,) ndarray
        The error allowed in any case; if the caller gave none, what follows from the start.
    """

    engine: str
    untraced_reason: str
    unseen_reason: str
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

    Parameters
    ----------
    t : (n,) ndarray
        The times asked for, those up to a terminal event.
    states : (n, k) ndarray
    events : tuple of Crossing
        One for each event function.
    at : callable or None
        at(time or times) returns (k,) or (n, k) states, if you asked for `dense`.
    report : Report
    """

    t: Array
    states: Array
    events: tuple[Crossing, ...]
    at: Callable[[ArrayLike], Array] | None
    report: Report
