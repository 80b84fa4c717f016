"""Decides during a run whether compiled code is worthwhile, and whether to give up, as with stiff equations.

Decisions depend on counts of steps, not on a clock, so the same call gives the same result. With an explicit method,
the fastest decay limits the step size, however smooth the motion is; and if the rates jump again and again, over a
quarter of the attempted steps are refused. A run is given up if many looks in a row detect one of these and far more
steps remain than anyone would wait for, or if its steps are hardly longer than the spacing of floats.
"""

import importlib.util
import os
from collections.abc import Callable, Sequence
from math import inf, sqrt

from tam570.integrate.error_scale import NO_SCALE, PART
from tam570.meter import is_limited
from tam570.values import Function, Numbers

PROBE = 50  # steps in Python before the first estimate of the remaining work
# Measured on a machine of 2024, median of the public problems of `benchmarks`; ratios differ little between machines:
IN_PYTHON, BESIDE = 3e-8, 12.0  # s per operation of the right-hand side in a stage; overhead of a stage, in operations
A_MODULE, AN_OPERATION = 0.15, 0.0012  # s, to import llvmlite; s per operation, to compile
FIRST_OF = 3.0  # calls that share the cost of compilation, as compiled code is cached on disk


class WorthCompiling(Exception):
    """Raised if compiling is worthwhile (see `repays`): the run then starts again in compiled code."""


class Estimate:
    """Counts the steps of a run in Python, and estimates the remaining work after 50, 100, 200, ... steps.

    begin, end : of the run, s; operations : their number in the right-hand side
    """

    def __init__(self, begin: float, end: float, operations: int) -> None:
        self.begin, self.end, self.operations = begin, end, operations
        self.steps, self.due = 0, PROBE

    def add(self, steps: int, t: float) -> None:
        """Count `steps` that led to the time t; raise WorthCompiling if compiling repays for the rest."""
        self.steps += steps
        if self.steps < self.due or t >= self.end:
            return
        self.due *= 2
        done = (t - self.begin) / (self.end - self.begin)
        if done and repays(self.steps * (1 / done - 1), self.operations):
            raise WorthCompiling


def repays(steps: float, operations: int) -> bool:
    """Return whether compilation is available and faster than `steps` steps of order 8 in each of FIRST_OF calls."""
    in_python = IN_PYTHON * 12 * steps * (operations + BESIDE)
    return in_python * FIRST_OF > A_MODULE + AN_OPERATION * operations and available()


def available() -> bool:
    """Return whether llvmlite is installed and not disabled by TAM570_COMPILED=0, and no meter counts the steps."""
    return (
        not is_limited()
        and os.environ.get("TAM570_COMPILED") != "0"
        and importlib.util.find_spec("llvmlite") is not None
    )


Look = Callable[..., None]

PYTHON = 300_000  # remaining steps that are too many: about ten seconds in Python
COMPILED = 30_000_000  # the same in compiled code
OUT_OF_REACH = 1e9  # the same if over a quarter of the attempts are refused, for a traced function
BETWEEN_LOOKS = 500  # attempted steps, at least
LOOKS, IDLE_LOOKS = 20, 10  # consecutive looks that detect stiffness, or many refusals, until the run is given up
CRAWL = 2.0**-48  # too small an advance per attempt, as a fraction of the time: four times the shortest step
DECAY = 1.5  # h times the fastest decay rate; it is less where accuracy limits h
SWEEPS = 8  # iterations of the power method: accurate to a factor of two if one decay is far faster than the rest


def watch_for_end(
    rhs: Function, c: Numbers, origin: float, end: float, sign: float, too_many: int, in_vain: float
) -> Look:
    """Return look(t, y, m, steps, refusals, by_rounding), to be called between steps of a run up to `end`.

    It raises ArithmeticError if the run should be given up.

    t, m     : s, time since `origin`; m() returns the scale of each component
    steps, refusals : accepted and refused steps so far
    by_rounding : whether steps are refused because of round-off
    sign     : -1 if the engine's time is -t, else 1
    too_many, in_vain : remaining steps that are too many if stiff, and if steps are refused
    """
    before, stiff_looks, idle_looks, blurred_looks, crawling_looks = (0.0, 0, 0), 0, 0, 0, 0

    def look(t: float, y: Sequence[float], m: Function, steps: int, refusals: int, by_rounding: bool = False) -> None:
        nonlocal before, stiff_looks, idle_looks, blurred_looks, crawling_looks
        moved, accepted, refused = t - before[0], steps - before[1], refusals - before[2]
        tried = accepted + refused
        if tried < BETWEEN_LOOKS:
            return
        before = t, steps, refusals
        left, h = (end - t) * tried / moved if moved > 0.0 else inf, moved / max(accepted, 1)
        is_idle, is_long = refused > tried / 4 and left > in_vain, end - t > too_many * h > 0.0
        is_stiff = (is_idle or is_long) and _decay(rhs, origin + t, y, m(), c) * h > DECAY
        stiff_looks = stiff_looks + 1 if is_stiff and is_long else 0
        idle_looks = idle_looks + 1 if is_idle and not is_stiff else 0
        blurred_looks += by_rounding
        crawling_looks = crawling_looks + 1 if moved < CRAWL * tried * abs(origin + t) else 0
        if stiff_looks >= LOOKS:
            raise ArithmeticError(
                f"stiff at t = {sign * (origin + t):.6g}: stability, not accuracy, keeps the steps at {h:.1g}, and "
                f"{(end - t) / h:.1g} of them are left. "
                'scipy.integrate.solve_ivp with method="Radau" or method="LSODA" is made for such equations'
            )
        if idle_looks >= IDLE_LOOKS:
            raise (blur if 2 * blurred_looks > idle_looks else chatter if left > OUT_OF_REACH else _crawl)(
                sign * (origin + t), y
            )
        if crawling_looks >= 2 * LOOKS:
            raise blur(sign * (origin + t), y)

    return look


def chatter(t: float, y: Sequence[float]) -> ArithmeticError:
    """Return the error for a motion that stays at a discontinuity of the rates, or finds the next one at once."""
    return ArithmeticError(
        f"the rates jump to and fro at t = {t:.9g}, y = {list(y)}: the motion stays where they jump or are infinitely "
        "steep, or rhs counts in tiny units, as t // 1e-6 does. If friction holds a body at rest, it has no rate: "
        "stop at an event, or smooth the jump. If rhs counts, compare t with both ends of an interval instead"
    )


def blur(t: float, y: Sequence[float]) -> ArithmeticError:
    """Return the error for rates whose round-off is larger than the tolerance allows."""
    return ArithmeticError(
        f"the rates near t = {t:.9g}, y = {list(y)} change by more than rtol allows within the rounding of time and "
        "state: at a short pulse, at a stiff wall, or where they become infinite. Count time from there, lengths "
        "from the wall; or give a larger rtol"
    )


def _crawl(t: float, y: Sequence[float]) -> ArithmeticError:
    """Return the error for rates that jump every few steps."""
    return ArithmeticError(
        f"the rates jump every few steps near t = {t:.9g}, y = {list(y)}, or are infinitely steep, and far too many "
        "steps are left. Let rhs compute with all digits (no round, no float32) and forget earlier calls, or give a "
        "larger rtol"
    )


def _decay(rhs: Function, t: float, y: Sequence[float], m: Sequence[float], c: Numbers) -> float:
    """Return the rate of the fastest decay, 1/s, by the power method; 0 if the fastest mode does not decay."""
    rates, along, back = rhs(t, tuple(y), c), [(-1.0 if i % 2 else 1.0) for i in range(len(y))], 0.0
    for _ in range(SWEEPS):
        size = sqrt(sum(a * a for a in along)) / PART
        changed = [v + a / size * scale for v, a, scale in zip(y, along, m, strict=True)]
        moved = rhs(t, tuple(changed), c)
        onward = [
            (b - a) / scale * size if scale > NO_SCALE else 0.0 for a, b, scale in zip(rates, moved, m, strict=True)
        ]
        fastest = sqrt(sum(b * b for b in onward))
        if not 0 < fastest < 1e300:
            return 0.0
        back = -sum(a * b for a, b in zip(along, onward, strict=True)) / (size * PART * fastest)
        along, rate = onward, fastest / (size * PART)
    return rate if back > 0.9 else 0.0
