"""Step size and samples: the loop around the generated step. Plain enough for a compiler to take as it is.

The functions written for one right-hand side (rhs, euler, raised, step, dense, at) are handed in once; what comes
back is the loop for that right-hand side.
"""

from collections.abc import Callable
from functools import partial
from math import inf, sqrt
from typing import Any, NamedTuple

from tam570.integrate.scale import UNKNOWN

__all__ = [
    "AT_A_JUMP",
    "AT_REST",
    "EXPONENT",
    "HANDED",
    "JUMP",
    "LACKS_SCALE",
    "LARGEST",
    "NOT_FINITE",
    "PLAUSIBLE",
    "RUNNING",
    "SAFETY",
    "SMALLEST",
    "STOPPED",
    "STUBBORN",
    "TOO_SHORT",
    "UNKNOWN",
    "State",
    "advance",
    "first_step_with",
    "let_pass",
    "loop_with",
]

SAFETY = 0.9
LARGEST, SMALLEST = 6.0, 0.2  # change of the step size from one step to the next
EXPONENT = -1 / 8
ROUNDING = 32.0  # an error up to so many times what a rounding of the state does to h f is not the method's
FINEST = 1e16  # the same over rtol, at most: at the last digits an error of one rounding is all that is let pass
JUMP = 1e-11  # error of the shortest of all steps, relative: a jump of the rates passes, a singularity does not
PLAUSIBLE = 0.005  # of the third's power 9/4, the error of exp(a t) and of its like is 0.02 and more
TINY = 2.0**-42  # of the largest magnitude over rtol: what is smaller is looked at, whatever the units
STUBBORN = 0.01  # an error that falls no faster from one attempt to the next may be rounding; a long step's does
AT_A_JUMP = 200.0  # of the rates the estimate is but a part of the error; the ratio of both estimates tells it
AT_REST = 8  # steps at least: where nothing moves, no error says how far to look for what sets in later

HANDED = ("raised", "step", "dense", "at")  # what `advance` is given of the generated functions
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
    return partial(advance, (raised, step, dense, at))


def advance(made: Any, origin: Any, times: Any, out: Any, state: Any, c: Any, rtol: Any, budget: Any) -> Any:
    """Fill the rows of `out` until none is left, `budget` steps are tried, or it has to halt.

    made : the generated functions; times : since `origin`; state : a `State`, as returned
    """
    (raised, step, dense, at), end, plausible = made, times[len(times) - 1], PLAUSIBLE / rtol
    row, t, h, y, r, f, m, growth, refused, steps, refusals, halt, before = state
    while row < len(times) and budget > 0 and halt == RUNNING:
        budget -= 1
        left, shortest = end - t, max(2.0**-50 * t, 1e-17 * end)  # t + h would hardly differ from t
        at_last, h = h <= shortest, max(h, shortest)
        if h >= left:
            h, new = left, end
        else:
            new = t + (h if 2 * h < left else left / 2)
            h = new - t  # exactly: else the rounding of t would shift the motion
        n, rest, g, size, fifth, third, stages = step(origin + t, h, y, r, f, m, c)
        error = fifth / (rtol * sqrt(fifth + 0.01 * third)) if fifth > 0 else fifth
        if error < 1:  # the fifth may pass through zero
            error = max(error, plausible * third**1.125)
        if refused > 0 and fifth > 0.01 * third:
            error *= AT_A_JUMP
        if error <= 1 or _passed(at_last, error * rtol, n, m):
            if times[row] <= new:
                row = _sampled(dense, at, origin, times, out, row, t, new, h, (y, n, f, g, stages), c)
            t, y, r, f, m = new, n, rest, g, size
            h = h * min(growth, SAFETY * error**EXPONENT) if 0 < error <= 1 else max(h, min(growth * h, end / AT_REST))
            growth, refused, before = LARGEST, 0, inf
            steps += 1
            look = steps == 1 and _uneven(m, rtol)
        else:
            refused, refusals, growth = refused + 1, refusals + 1, 1.0
            h, halt, look = _shorter(h, at_last, error, fifth > 0.01 * third or STUBBORN * before < error, n, m)
            before = error
        if look:
            small, m = m, raised(origin + t, h, y, f, m, c, let_pass(rtol), max(2.0 * refused - 1.0, 1.0))
            if _larger(small, m):  # it was rounding, and no jump
                refused, before = 0, inf
    return State(row, t, h, y, r, f, m, growth, refused, steps, refusals, halt, before)


def let_pass(rtol: Any) -> Any:
    """Magnitude over what a rounding of the state does to h f, at least."""
    return min(ROUNDING / rtol, FINEST)


def _sampled(
    dense: Any, at: Any, origin: Any, times: Any, out: Any, row: Any, t: Any, new: Any, h: Any, step: Any, c: Any
) -> Any:
    """The next row, those that the step reaches being filled."""
    y, n, f, g, stages = step
    if times[row] < new:
        q = dense(origin + t, h, y, n, f, g, stages, c)
        while times[row] < new:
            at(out, row, (times[row] - t) / h, y, q)
            row += 1
    if times[row] == new:
        for i in range(len(n)):
            out[row, i] = n[i]
        row += 1
    return row


def _passed(at_last: Any, error: Any, n: Any, m: Any) -> Any:
    """Whether the shortest of all steps is taken all the same: across a jump, not into a singularity."""
    if not at_last:
        return False
    lacking, finite = _moving(n, m)
    return finite and (lacking or error <= JUMP)


def _shorter(h: Any, at_last: Any, error: Any, doubtful: Any, n: Any, m: Any) -> Any:
    """The step to be tried next, why the run halts, and whether to look for rounding."""
    lacking, finite = _moving(n, m)
    if at_last:
        return h, TOO_SHORT if finite else NOT_FINITE, False
    if lacking or not error < 1e300:
        return 0.1 * h, LACKS_SCALE if lacking else RUNNING, False
    return h * max(SMALLEST, SAFETY * error**EXPONENT), RUNNING, doubtful


def _moving(n: Any, m: Any) -> Any:
    """Whether something moves that has no scale, and whether all is finite."""
    lacking, finite = False, True
    for i in range(len(n)):
        lacking = lacking or m[i] <= UNKNOWN < abs(n[i])
        finite = finite and n[i] - n[i] == 0.0
    return lacking, finite


def _uneven(m: Any, rtol: Any) -> Any:
    """Whether rounding of the largest may be all that moves the smallest."""
    low = high = m[0]
    for i in range(len(m)):
        low, high = min(low, m[i]), max(high, m[i])
    return low * rtol < TINY * high


def _larger(small: Any, m: Any) -> Any:
    """Whether any has become larger."""
    found = False
    for i in range(len(m)):
        found = found or small[i] < m[i]
    return found
