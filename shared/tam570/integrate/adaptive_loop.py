"""Step size and samples: the loop around the generated step. Plain enough for a compiler to take as it is.

The functions written for one right-hand side (rhs, euler, raised, step, dense, at) are handed in once; what comes
back is the loop for that right-hand side.
"""

from collections.abc import Callable
from math import inf, sqrt
from typing import Any, NamedTuple

from tam570.integrate.scale import UNKNOWN

__all__ = [
    "AT_A_JUMP",
    "AT_REST",
    "EXPONENT",
    "JUMP",
    "LACKS_SCALE",
    "LARGEST",
    "NOT_FINITE",
    "PLAUSIBLE",
    "ROUNDING",
    "RUNNING",
    "SAFETY",
    "SMALLEST",
    "STOPPED",
    "STUBBORN",
    "TOO_SHORT",
    "UNKNOWN",
    "State",
    "first_step_with",
    "loop_with",
]

SAFETY = 0.9
LARGEST, SMALLEST = 6.0, 0.2  # change of the step size from one step to the next
EXPONENT = -1 / 8
ROUNDING = 1.0  # an error up to so many times what a few roundings of the state do to h f is not the method's
JUMP = 1e-11  # error of the shortest of all steps, relative: a jump of the rates passes, a singularity does not
PLAUSIBLE = 0.005  # of the third's power 9/4, the error of exp(a t) and of its like is 0.02 and more
STUBBORN = 0.01  # an error that falls no faster from one attempt to the next may be rounding; a long step's does
AT_A_JUMP = 200.0  # of the rates the estimate is but a part of the error; the ratio of both estimates tells it
AT_REST = 8  # steps at least: where nothing moves, no error says how far to look for what sets in later

RUNNING, LACKS_SCALE, TOO_SHORT, NOT_FINITE, STOPPED = 0, 1, 2, 3, 4  # why a loop comes back


class State(NamedTuple):
    """Where a run is."""

    row: int  # the next sample
    t: float  # s, since the start
    h: float  # s, to be tried next
    y: tuple[float, ...]
    r: tuple[float, ...]  # what rounding took from y
    f: tuple[float, ...]  # the derivative
    m: tuple[float, ...]  # the largest magnitude of each component so far
    growth: float  # of the next step, at most
    refused: int  # attempts in a row
    steps: int
    refusals: int
    halt: int  # RUNNING, or why it goes no further: LACKS_SCALE is mended by `m`
    error: float = inf  # of the attempt before


def first_step_with(rhs: Any, euler: Any) -> Callable[..., float]:
    """The function that finds the first step of a run."""

    def first_step(origin: Any, span: Any, y: Any, f: Any, c: Any) -> Any:
        """A step across which the derivative changes little, found from above: a derivative of zero deceives nobody."""
        h = span / 100 or span
        while h > 1e-9 * span:
            onward = euler(h, y, f)
            g = rhs(origin + h, onward, c)
            # What starts at zero at zero rate does nothing to the others before a second step.
            if not (_restless(h, y, f, g, 0.1) or _restless(h, y, f, rhs(origin + 2 * h, euler(h, onward, g), c), 0.3)):
                break
            h /= 4
        return h

    return first_step


def _restless(h: float, y: Any, f: Any, g: Any, part: float) -> bool:
    """Whether the derivative changes by more than a part of the state, or of itself, within h.

    What starts at zero with zero rate has no scale to compare with and is left to the estimates of the steps.
    """
    for i in range(len(y)):
        size = max(abs(y[i]), h * abs(f[i]))
        if size > 0 and not h * abs(g[i] - f[i]) <= part * max(size, h * abs(g[i])):
            return True
    return False


def loop_with(raised: Any, step: Any, dense: Any, at: Any) -> Callable[..., State]:
    """The loop over the steps of a run."""

    def advance(origin: Any, times: Any, out: Any, state: Any, c: Any, rtol: Any, budget: Any) -> Any:
        """Fill the rows of `out` until none is left, `budget` steps are tried, or it has to halt.

        times : since `origin`; state : a `State`, as returned
        """
        row, t, h, y, r, f, m, growth, refused, steps, refusals, halt, before = state
        rows, end = len(times), times[len(times) - 1]
        while row < rows and budget > 0 and halt == RUNNING:
            budget -= 1
            left = end - t
            shortest = max(2.0**-50 * t, 1e-17 * end)  # t + h would hardly differ from t
            h = max(h, shortest)
            at_last = h == shortest
            if h >= left:
                h, new = left, end
            else:
                new = t + (h if 2 * h < left else left / 2)
                h = new - t  # exactly: else the rounding of t would shift the motion
            n, rest, g, size, fifth, third, stages = step(origin + t, h, y, r, f, m, c)
            error = fifth / (rtol * sqrt(fifth + 0.01 * third)) if fifth > 0 else fifth
            if error < 1:  # the fifth may pass through zero
                error = max(error, PLAUSIBLE / rtol * third**1.125)
            if refused > 0 and fifth > 0.01 * third:
                error *= AT_A_JUMP
            lacking, finite = False, True
            if not error <= 1:
                for i in range(len(n)):
                    lacking = lacking or m[i] <= UNKNOWN < abs(n[i])
                    finite = finite and n[i] - n[i] == 0.0
            if error <= 1 or (at_last and finite and (lacking or error * rtol <= JUMP)):
                if times[row] < new:
                    q = dense(origin + t, h, y, n, f, g, stages, c)
                    while times[row] < new:
                        at(out, row, (times[row] - t) / h, y, q)
                        row += 1
                if times[row] == new:
                    for i in range(len(n)):
                        out[row, i] = n[i]
                    row += 1
                t, y, r, f, m = new, n, rest, g, size
                if 0 < error <= 1:
                    h *= min(growth, SAFETY * error**EXPONENT)
                else:
                    h = max(h, min(growth * h, end / AT_REST))
                growth, refused, before = LARGEST, 0, inf
                steps += 1
            else:
                refused += 1
                refusals += 1
                if at_last:
                    halt = TOO_SHORT if finite else NOT_FINITE
                elif lacking:
                    halt = LACKS_SCALE
                elif STUBBORN * before < error < 1e300:
                    m = raised(origin + t, h, y, f, m, c, ROUNDING / rtol, 2.0 * refused - 1.0)
                h *= max(SMALLEST, SAFETY * error**EXPONENT) if error < 1e300 and not lacking else 0.1
                growth = 1.0
                before = error if error < 1e300 else inf
        return State(row, t, h, y, r, f, m, growth, refused, steps, refusals, halt, before)

    return advance
