"""Times of simulations: uneven ones for every check, and calls that follow one another."""

import numpy as np
from numpy.typing import NDArray

from tam570.values import Numbers
from tam570_grader.checks.case import Case

Array = NDArray[np.float64]
# label: selection from an array of times, which a closed form must accept, too
SOME_TIMES = {"a single time": slice(-1, None), "times in descending order": slice(None, None, -1)}

KEPT = "Is anything kept between calls?"


def uneven(rng: np.random.Generator, span: float, count: int, start: float | None = None) -> Array:
    """Return `count` unevenly spaced times over a span, from `start`, by default a random time other than zero."""
    steps = np.append(0.0, np.cumsum(rng.uniform(0.2, 1.8, count - 1)))
    if start is None:
        start = span * rng.uniform(0.3, 0.6) * rng.choice([-1, 1])
    return np.asarray(start + span * steps / steps[-1])


def repeated_calls(rng: np.random.Generator, case: Case, *, start: Numbers = None, **parameters: Numbers) -> list[Case]:
    """Return the simulation of a case at other times, from another start, and with other parameters.

    The first and last of three or more times stay. Call the case itself first: results kept between calls then show.

    start : the other arguments behind t, if random changes are not allowed
    parameters : other values; None keeps the value of the case
    """
    t, *arguments = case.args
    times = t[0] + (t - t[0]) ** 2 / (t[-1] - t[0])
    others = {name: parameters.get(name, _other(rng, value)) for name, value in case.kwargs.items()}
    changed = [
        case.replace(times if len(t) > 2 else 2 * times),
        case.replace(t, *(start or [_other(rng, argument) for argument in arguments])),
        case.replace(**{name: other for name, other in others.items() if other is not None}),
    ]
    return [other.labelled("a call like the one before", KEPT) for other in changed]


def _other(rng: np.random.Generator, value: Numbers) -> Numbers:
    """Return a changed value; change only the first of several numbers, because a common factor may change nothing."""
    if isinstance(value, str):
        return None
    factor = rng.uniform(1.2, 1.5)
    if np.ndim(value) == 0:
        return value * factor if value else factor
    other = np.array(value, float)
    other.flat[0] = other.flat[0] * factor if other.flat[0] else factor
    return other
