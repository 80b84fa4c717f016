"""The loop over the generated steps: step size control and samples. `translate` compiles its source, too.

The functions generated for a right-hand side, by the names in GENERATED, are passed in once.
"""

from collections.abc import Callable
from functools import partial
from math import inf, sqrt
from typing import NamedTuple

from tam570.integrate.error_scale import EPS, NO_SCALE
from tam570.values import Numbers

SAFETY = 0.9  # factor of the predicted step size, so that few steps are refused
LARGEST, SMALLEST = 6.0, 0.2  # limits of the change of the step size (6 as in dop853.f)
DOUBLED = 2.0  # largest growth of the step size after an error by round-off
EXPONENT = -1 / 8  # of the error in the predicted step size, for order 8
JUMP = 1e-9  # relative effect on the state of a change of rates in the shortest step: less at a jump, more at a pole
CROSSED = 1000.0  # tolerances, error of a step across a jump (the tolerance is 30 times less if rates may jump)
BLUNT, FINEST = 30.0, 1e-12  # limit of a step's round-off: tolerances of the largest component, or part of its size
COARSE = 300.0  # tolerances, the same for the effect of the round-off of time
BEFORE_END = 0.75  # of the last step, where its final rates are evaluated if they jump at the end
TRIALS, LONGER = 60, 0.02  # attempts if the rates are not finite, with the shortest step and its growth per attempt
BLURRED, BRIEF = 256.0, 1e-9  # brief steps, in shortest steps: times in them have errors of a thousandth; of the run
LEAP = 1e-4  # relative change of the state in a brief step that indicates a pole, for any error estimate
SUSPICIOUS = 0.005  # least error, in units of the third-order estimate to the power 9/4. For exp(a t) etc. it is 0.02
# and more; a smaller error means that the fifth-order estimate passes through zero
NOT_SMOOTH = 0.01  # squared ratio of fifth- to third-order estimate: less in a short step of a smooth motion
JAGGED = 0.1  # the same for a step of any length
AT_A_JUMP = 200.0  # factor of the error at a jump of the rates, detected by this ratio: the estimate sees only a part
AT_A_KINK = 1000.0  # the same if the argument of abs etc. crosses zero
UNSEEN = 256.0  # error of a step that may have missed a saturating function: half the step is tried next
AT_REST = 8  # steps of a run, at least: if nothing moves, no error limits steps before a force that sets in later

# The generated functions that `advance` takes:
GENERATED = ("step", "cross", "error_norms", "roundoff", "lesser", "reach", "bends", "passed", "dense", "at")
RUNNING, SETS_IN, TOO_SHORT, NOT_FINITE, STOPPED, COARSE_CLOCK = 0, 1, 2, 3, 4, 5  # why `advance` returns


class State(NamedTuple):
    """State of a run."""

    row: int  # the next sample
    t: float  # s, since the start
    h: float  # s, next step size to try
    y: tuple[float, ...]
    r: tuple[float, ...]  # compensation: round-off lost from y (Kahan)
    f: tuple[float, ...]  # the derivative
    a: tuple[float, ...]  # the absolute tolerance
    b: tuple[float, ...]  # round-off of the error estimates: the lesser of the last two measurements
    measured: tuple[float, ...]  # the last measurement
    growth: float  # largest growth of the next step size
    refused: int  # consecutive refusals
    steps: int
    refusals: int
    halt: int  # RUNNING, or why the run cannot continue
    pace: float = 0.0  # s, step size before a switch limited it


def loop_with(*generated: Numbers) -> Callable[..., State]:
    """Return the loop over the steps of a run."""
    return partial(advance, generated)


def advance(
    generated: Numbers,
    origin: Numbers,
    times: Numbers,
    out: Numbers,
    state: Numbers,
    c: Numbers,
    rtol: Numbers,
    longest: Numbers,
    budget: Numbers,
) -> Numbers:
    """Fill the rows of `out` until none is left, `budget` steps are tried, or the run must halt; return the `State`.

    generated : functions in the order of GENERATED; times : since `origin`; state : a `State`
    longest   : s, largest step size
    """
    step, cross, error_norms, roundoff, lesser, reach, bends, passed, dense, at = generated
    end = times[len(times) - 1]
    row, t, h, y, r, f, a, b, measured, growth, refused, steps, refusals, halt, pace = state
    suspicious = SUSPICIOUS * rtol**1.25  # of errors in units of the tolerance
    while row < len(times) and budget > 0 and halt == RUNNING:
        budget -= 1
        remaining = end - t
        shortest = max(2.0**-50 * t, 2.0**-50 * abs(origin + t), 1e-30 * end)  # t + h would hardly differ from t
        shortest *= 1.0 + LONGER * refused  # another step may avoid a 0/0
        limit = reach(origin + t, h, y, f, c) if reach else inf
        pace = max(pace, h) if limit < h else pace
        h = min(h, longest, limit) if h > longest or h > limit else h
        at_last = h <= shortest
        h = shortest if at_last else h
        if h >= remaining:
            h, new = remaining, end
        else:
            new = t + (h if 2 * h < remaining else remaining / 2)
            h = new - t  # exactly, or round-off of t would shift the motion
        n, rest, g, fifth, third, stages = step(origin + t, h, y, r, f, a, b, rtol, c)
        uneven = fifth > NOT_SMOOTH * third
        part = 1.0 / AT_A_JUMP if uneven and (refused > 0 or fifth > JAGGED * third) else 1.0
        part = 1.0 / AT_A_KINK if bends and bends(origin + t, h, y, f, n, g, c) else part
        error = _error(fifth, third, suspicious) / part
        may_be_rounding = not error <= 1.0 and fifth < inf and (refused > 0 or uneven)
        if may_be_rounding:
            before, measured = measured, roundoff(origin + t, h, y, f, b, c)
            if not is_blurred(measured, y, a, rtol):
                b = lesser(before, measured)
                fifth, third = error_norms(h, y, n, f, g, a, measured, part, part * rtol, stages)
                error = _error(fifth, third, suspicious)
        if reach and error <= 1.0 and not at_last and h > 2.0 * reach(origin + new, h, n, g, c):
            error = UNSEEN
        sure = passed(origin + t, h, y, f, n, g, a, error, shortest, c) if passed and fifth < inf else inf
        is_brief = h < BLURRED * shortest
        error = UNSEEN if is_brief and h < BRIEF * end and error <= 1.0 and _leaps(h, y, n, g, a, rtol, LEAP) else error
        is_cut = sure < h and not at_last
        crosses = at_last and (sure <= h or new == end)
        if crosses and not error <= 1.0:
            n, rest, g = _crossed(cross, new == end, origin + t, h, (y, r, f), c)
        jumps = at_last and fifth < inf and _finite(n) and _jumps(crosses, h, y, n, f, g, a, rtol)
        is_coarse = error <= 1.0 and not at_last and _is_coarse(cross, origin + t, h, (y, r, f), g, a, rtol, c)
        halt = COARSE_CLOCK if is_coarse else halt
        if (error <= 1.0 or jumps) and not is_cut:
            if at_last and ((jumps and _sets_in(y, n, a)) or (crosses and pace > 0.0 and _has_no_scale(a))):
                halt = SETS_IN
            if times[row] <= new:
                row = _sampled((dense, at, c), origin, times, out, row, (t, new, h, y, n, f, g, stages))
            t, y, r, f = new, n, rest, g
            h = _longer(h, error, growth, may_be_rounding, end)
            if is_brief and pace > 0.0:  # the step may have crossed a switch
                h, pace = max(h, pace), 0.0
            growth, refused = LARGEST, 0
            steps += 1
        else:
            refused, refusals, growth = refused + 1, refusals + 1, 1.0
            if at_last and (refused > TRIALS or _finite(n) and fifth < inf):
                halt = TOO_SHORT if _finite(n) and fifth < inf else NOT_FINITE
            pace = max(0.5 * h, pace) if is_cut else pace
            refused = 0 if is_cut else refused
            h = _shorter(h, error, sure)
    return State(row, t, h, y, r, f, a, b, measured, growth, refused, steps, refusals, halt, pace)


def _longer(h: Numbers, error: Numbers, growth: Numbers, may_be_rounding: Numbers, end: Numbers) -> Numbers:
    """Return the step size after an accepted step."""
    if may_be_rounding and error <= 1.0:  # a shorter step would not reduce round-off
        h = h * min(growth, DOUBLED)
    elif 0 < error <= 1:
        longer = SAFETY * error**EXPONENT
        h = h * (longer if longer < growth else growth)
    else:
        h = max(h, min(growth * h, end / AT_REST))
    return h


def _shorter(h: Numbers, error: Numbers, sure: Numbers) -> Numbers:
    """Return the step size after a step that was too long, or that crossed a switch `sure` s after its start."""
    if sure < h:
        h = sure if error <= 1.0 else min(sure, 0.5 * h)
    elif error < 1e300:
        h = h * max(SMALLEST, SAFETY * error**EXPONENT)
    else:
        h = 0.1 * h
    return h


def is_blurred(b: Numbers, y: Numbers, a: Numbers, rtol: Numbers) -> Numbers:
    """Return whether the round-off of a step is more than the tolerance of the largest component allows.

    y : the state before the step, since a step that is far too long may end anywhere
    """
    noise = 0.0
    for i in range(len(b)):
        noise = max(noise, b[i])
    return min(JUMP, max(BLUNT * rtol, FINEST)) * _size(y, a, rtol) < noise


def _is_coarse(
    cross: Numbers, start: Numbers, h: Numbers, state: Numbers, g: Numbers, a: Numbers, rtol: Numbers, c: Numbers
) -> Numbers:
    """Return whether the rates change too much within the round-off of time, which no error estimate detects."""
    rounding, limit = EPS * abs(start), max(COARSE * rtol, 10.0 * FINEST)
    is_coarse = False
    if rounding > limit * h:
        y, r, f = state
        is_coarse = rounding * _largest_change(f, g) > limit * _size(y, a, rtol)
        if is_coarse:  # if only time changes?
            _, _, later = cross(start + h, 0.0, y, r, f, c)
            is_coarse = rounding * _largest_change(f, later) > limit * _size(y, a, rtol)
    return is_coarse


def _largest_change(f: Numbers, g: Numbers) -> Numbers:
    """Return the largest absolute difference."""
    change = 0.0
    for i in range(len(f)):
        change = max(change, abs(g[i] - f[i]))
    return change


def _size(y: Numbers, a: Numbers, rtol: Numbers) -> Numbers:
    """Return the size of the largest component, including its scale."""
    size = 0.0
    for i in range(len(y)):
        size = max(size, abs(y[i]) + a[i] / rtol)
    return size


def _error(fifth: Numbers, third: Numbers, suspicious: Numbers) -> Numbers:
    """Return the error of a step in tolerances, from both squared estimates (Hairer, Norsett, Wanner, II.10)."""
    error = fifth / sqrt(fifth + 0.01 * third) if fifth > 0 else fifth
    if error < 1:  # the fifth-order estimate may pass through zero
        least = suspicious * third**1.125
        error = least if least > error else error
    return error


def _sampled(generated: Numbers, origin: Numbers, times: Numbers, out: Numbers, row: Numbers, step: Numbers) -> Numbers:
    """Fill the rows of the samples in a step; return the next row."""
    dense, at, c = generated
    t, new, h, y, n, f, g, stages = step
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


def _crossed(cross: Numbers, ends: Numbers, start: Numbers, h: Numbers, state: Numbers, c: Numbers) -> Numbers:
    """Return state and rates beyond a jump; if the run ends there, rates from before its end, without the jump."""
    y, r, f = state
    n, rest, g = cross(start, h, y, r, f, c)
    if ends:
        _, _, g = cross(start, BEFORE_END * h, y, r, f, c)
    return n, rest, g


def _jumps(
    crosses: Numbers, h: Numbers, y: Numbers, n: Numbers, f: Numbers, g: Numbers, a: Numbers, rtol: Numbers
) -> Numbers:
    """Return whether the shortest step crosses a jump of the rates, not a pole: its effect on the state is small.

    The effect is relative to the state; components that start from zero without scale are ignored.
    """
    limit = CROSSED * rtol
    largest = 0.0
    for i in range(len(n)):
        w, x = a[i] / rtol + max(abs(y[i]), abs(n[i])), h * abs(g[i] - f[i])
        if (y[i] != 0.0 or a[i] > NO_SCALE) and not x <= largest * w:
            largest = x / w
    return largest <= (limit if crosses else min(limit, JUMP)) and not (crosses and _leaps(h, y, n, g, a, rtol, limit))


def _sets_in(y: Numbers, n: Numbers, a: Numbers) -> Numbers:
    """Return whether a component without scale begins to move, so that it needs a scale, as at the start of a run."""
    moves = False
    for i in range(len(n)):
        moves = moves or (a[i] <= NO_SCALE and y[i] == 0.0 and n[i] != 0.0)
    return moves


def _leaps(h: Numbers, y: Numbers, n: Numbers, g: Numbers, a: Numbers, rtol: Numbers, part: Numbers) -> Numbers:
    """Return whether a short step moves the state by a fraction `part` of its size, as next to a pole of the rates."""
    moved, size = 0.0, 0.0
    for i in range(len(n)):
        if a[i] > NO_SCALE:
            moved, size = max(moved, h * abs(g[i]), abs(n[i] - y[i])), max(size, abs(n[i]), a[i] / rtol)
    return moved > max(part, rtol) * size


def _has_no_scale(a: Numbers) -> Numbers:
    """Return whether any component has no scale yet."""
    lacks_scale = False
    for i in range(len(a)):
        lacks_scale = lacks_scale or a[i] <= NO_SCALE
    return lacks_scale


def _finite(n: Numbers) -> Numbers:
    """Return whether all numbers are finite."""
    finite = True
    for i in range(len(n)):
        finite = finite and n[i] - n[i] == 0.0
    return finite
