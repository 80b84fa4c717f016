"""What rounding does to the rates of a right-hand side that is called as it stands.

The rates are taken at neighbouring floats of time and state. Their differences bound what is known of them: an error
estimate below that is the rounding's, not the method's. Where only those on one side are
large, it is a jump of the rates, and does not count.
"""

import math
from collections.abc import Callable, Sequence

from tam570.integrate.binding import CalledRates
from tam570.integrate.dop853_source import ESTIMATE_ROUNDOFF
from tam570.values import Numbers

__all__ = ["roundoff_by_neighbours"]

EPS = 2.0**-52
PASSED_ON = 0.3  # of a step, after which the later stages see what rounding did to the earlier ones
ULPS = (1.37, 2.91, 5.3)  # by which a state is changed, times the pattern below: several, as one may round to nothing
PATTERN = (1.0, -1.41, 1.82, -1.0, 1.41, -1.82)  # no two components cancel
INSIDE = 0.4637  # of the step, where they are taken: no point at which a motion is likely to meet a jump
ONE_SIDED = 1e-3  # of the changes on one side, where those on the other are less: it is a jump

Changes = tuple[list[float], list[float]]  # the least and the largest of each rate


def roundoff_by_neighbours(rates: CalledRates) -> Callable[..., tuple[float, ...]]:
    """Return the function `roundoff(start, h, y, f, b, c)`.

    What rounding does to the error estimates of a step of h.
    """

    def roundoff(start: float, h: float, y: Numbers, f: Numbers, b: Numbers, _: Numbers) -> tuple[float, ...]:
        rates.check_memory(start, y, f)
        t, state = start + INSIDE * h, [v + INSIDE * h * rate for v, rate in zip(y, f, strict=True)]
        try:
            there = rates(t, tuple(state))
            above, below = (_changes(rates, t, h, state, there, side) for side in (1.0, -1.0))
        except (ArithmeticError, ValueError, LookupError):
            return tuple(b)
        noise = [_noise(*four) for four in zip(*above, *below, strict=True)]
        widths = [ESTIMATE_ROUNDOFF * h * x for x in noise]
        return tuple(x if x < math.inf else 0.0 for x in widths)

    return roundoff


def _noise(least: float, largest: float, other_least: float, other_largest: float) -> float:
    if largest < ONE_SIDED * other_least or other_largest < ONE_SIDED * least:
        return min(largest, other_largest)
    return max(largest, other_largest)


def _changes(
    rates: Callable[[float, Numbers], Sequence[float]], t: float, h: float, y: list[float], f: Numbers, side: float
) -> Changes:
    """Of each rate, on one side; what it does to the state within h is passed on to the next change."""
    least, largest, moved = [math.inf] * len(y), [0.0] * len(y), [0.0] * len(y)
    for ulps in ULPS:
        near = [
            v + side * ulps * PATTERN[i % 6] * EPS * abs(v) + d for i, (v, d) in enumerate(zip(y, moved, strict=True))
        ]
        changes = [g - rate for g, rate in zip(rates(t + side * ulps * EPS * abs(t), tuple(near)), f, strict=True)]
        least = [min(size, abs(change)) for size, change in zip(least, changes, strict=True)]
        largest = [max(size, abs(change)) for size, change in zip(largest, changes, strict=True)]
        moved = [PASSED_ON * h * change for change in changes]
    return least, largest
