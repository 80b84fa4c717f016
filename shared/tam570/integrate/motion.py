"""What `solve` returns when more is asked for than states: events, a function of time, a report."""

from bisect import bisect_left
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from tam570.integrate.arguments import Array
from tam570.integrate.binding import bound

__all__ = ["Crossing", "Event", "Motion", "Piece", "Report", "crossings", "events_of", "function_of_time"]

LOOKS = 8  # at an event function within a step: two crossings in one step are two


@dataclass(frozen=True)
class Report:
    """How a run went.

    engine      : "Python" or "compiled"
    why_called  : why the right-hand side was called as it stands instead of traced; empty if it was traced
    steps       : taken
    refusals    : steps that were too long and taken again
    evaluations : of the right-hand side by these steps, twelve each; None where compiled series took their place
    """

    engine: str
    why_called: str
    steps: int
    refusals: int
    evaluations: int | None


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


@dataclass(frozen=True)
class Piece:
    """A step: inside(x) is the state at the fraction x of it. t, h : s, those of the engine's clock."""

    t: float
    h: float
    inside: Callable[[float], Array]


@dataclass(frozen=True)
class Event:
    """A function whose zeros are looked for. direction : of the crossing, 0 for both; stops : at this one, 0 never."""

    value: Callable[[float, Array], float]
    direction: float
    stops: int


def events_of(given: Any, parameters: Mapping[str, Any] | None, sign: float) -> list[Event]:
    """One event or a list of them, with the attributes that solve_ivp knows; `sign` of the engine's clock."""
    functions = [] if given is None else [given] if callable(given) else list(given)
    return [_event(function, bound(function, parameters, "events"), sign) for function in functions]


def _event(function: Any, value: Callable[[float, Any], Any], sign: float) -> Event:
    direction, terminal = getattr(function, "direction", 0.0), getattr(function, "terminal", False)
    return Event(lambda t, y: float(value(sign * t, y)), float(direction), int(terminal))


def crossings(events: Sequence[Event], piece: Piece, signs: list[float]) -> list[tuple[float, int]]:
    """(fraction of the step, which event) of each crossing within a step, in order.

    signs : of each event function where it was last not zero, brought up to date: zero at the start is no crossing.
    """
    found = []
    for which, event in enumerate(events):
        x = 0.0
        for onward in (k / LOOKS for k in range(1, LOOKS + 1)):
            value = event.value(piece.t + onward * piece.h, piece.inside(onward))
            if value and signs[which] and (value > 0) != (signs[which] > 0) and value * event.direction >= 0:
                found.append((_located(event, piece, x, onward, value > 0), which))
            signs[which] = value or signs[which]
            x = onward
    return sorted(found)


def _located(event: Event, piece: Piece, low: float, high: float, positive: bool) -> float:
    """The fraction at which the event function takes its new sign: halved until no number is between."""
    while True:
        middle = (low + high) / 2
        if not low < middle < high:
            return high
        value = event.value(piece.t + middle * piece.h, piece.inside(middle))
        low, high = (low, middle) if value and (value > 0) == positive else (middle, high)


def function_of_time(pieces: Sequence[Piece], sign: float) -> Callable[[ArrayLike], Array]:
    """at(times) by the polynomials of the steps."""
    ends = [piece.t + piece.h for piece in pieces]

    def state(time: float) -> Array:
        t = sign * time
        if not pieces[0].t <= t <= ends[-1]:
            first, last = sorted((sign * pieces[0].t, sign * ends[-1]))
            raise ValueError(f"t: the motion is known from {first:g} to {last:g}, not at {time:g}")
        piece = pieces[min(bisect_left(ends, t), len(pieces) - 1)]
        return piece.inside((t - piece.t) / piece.h)

    def at(times: ArrayLike) -> Array:
        """(k,) the state at a time, or (n, k) at times; ValueError outside of the run."""
        asked = np.asarray(times, dtype=float)
        return state(float(asked)) if asked.ndim == 0 else np.array([state(float(time)) for time in asked])

    return at
