"""The times of simulations: uneven ones for every check, and cases that follow one another."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tam570_grader.checks.case import Case

__all__ = ["SOME_TIMES", "repeated_calls", "uneven"]

Array = NDArray[np.float64]
# kind: of an array of times, what a closed form must take, too
SOME_TIMES = {"a single time": slice(-1, None), "times in descending order": slice(None, None, -1)}

KEPT = "Is anything kept between calls?"


def uneven(rng: np.random.Generator, span: float, count: int, start: float | None = None) -> Array:
    """`count` times of uneven spacing over a span, from `start`, or from anywhere but zero."""
    steps = np.append(0.0, np.cumsum(rng.uniform(0.2, 1.8, count - 1)))
    if start is None:
        start = span * rng.uniform(0.3, 0.6) * rng.choice([-1, 1])
    return np.asarray(start + span * steps / steps[-1])


def repeated_calls(rng: np.random.Generator, case: Case, **others: Any) -> list[Case]:
    """A simulation again, and with one argument changed at a time: what is kept from a call is wrong then.

    others : other values of parameters, None for no other, or start=(...) the arguments behind t, where a random
             change is not allowed
    """
    t = case.args[0]
    again = case.labelled("a motion that is asked for again", KEPT)
    span = t[-1] - t[0]
    changed = [case.replace(uneven(rng, span, len(t), t[0] + rng.uniform(1, 3)))]
    if len(t) > 2:
        changed.append(case.replace(t[0] + (t - t[0]) ** 2 / span))  # of the same first and last
    starts = others.pop("start", None) or [_other(rng, one) for one in case.args[1:]]
    for place, start in enumerate(starts, start=1):
        if start is not None:
            changed.append(case.replace(*case.args[:place], start))
    for name, value in case.kwargs.items():
        if (other := others.get(name, _other(rng, value))) is not None:
            changed.append(case.replace(**{name: other}))
    return [again, *(one.labelled("the call before with one argument changed", KEPT) for one in changed)]


def _other(rng: np.random.Generator, value: Any) -> Any:
    """A value that differs: of several numbers only the first, for what grows alike may change nothing."""
    if isinstance(value, str):
        return None
    factor = rng.uniform(1.2, 1.5)
    if np.ndim(value) == 0:
        return value * factor if value else factor
    other = np.array(value, float)
    other.flat[0] = other.flat[0] * factor if other.flat[0] else factor
    return other
