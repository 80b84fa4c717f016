"""What is decided while a run goes on: whether compiled code repays, and whether the equations are stiff.

The work is counted and no clock is read: the same call gives the same answer. An explicit method takes steps no longer
than the fastest decay allows, however smooth the motion. A run is given up when that holds at twenty looks in a row,
and far more steps are left than anybody waits for.
"""

import importlib.util
import os
from collections.abc import Callable, Sequence
from math import sqrt

from tam570.integrate.error_scale import NO_SCALE, PART
from tam570.values import Function, Numbers

__all__ = ["COMPILED", "PYTHON", "Estimate", "Look", "WorthCompiling", "available", "repays", "stiffness_watch"]

PROBE = 50  # steps in Python before the rest is estimated for the first time
# On a machine of 2024, median of the public problems of `benchmarks`, s; another machine has about the same ratios:
IN_PYTHON, BESIDE = 3e-8, 12.0  # an operation of the right-hand side, at a stage; a stage costs so many more
A_MODULE, AN_OPERATION = 0.15, 0.0012  # to import llvmlite and to compile
FIRST_OF = 3.0  # calls: compiled code is kept on disk, for the next one and the next process


class WorthCompiling(Exception):
    """The rest of the run takes longer in Python than the whole of it does compiled."""


class Estimate:
    """Counts the steps of a run in Python, and estimates the rest after 50, 100, 200, ... of them.

    Parameters
    ----------
    begin, end : float
        Of the run, s.
    operations : int
        Of the right-hand side.
    """

    def __init__(self, begin: float, end: float, operations: int) -> None:
        self.begin, self.end, self.operations = begin, end, operations
        self.steps, self.due = 0, PROBE

    def add(self, steps: int, t: float) -> None:
        """Count steps up to the time t. Raises WorthCompiling."""
        self.steps += steps
        if self.steps < self.due or t >= self.end:
            return
        self.due *= 2
        done = (t - self.begin) / (self.end - self.begin)
        if done and repays(self.steps * (1 / done - 1), self.operations):
            raise WorthCompiling


def repays(steps: float, operations: int) -> bool:
    """Return whether so many steps of order 8 take longer in Python than compiling does, for one of some calls."""
    in_python = IN_PYTHON * 12 * steps * (operations + BESIDE)
    return in_python * FIRST_OF > A_MODULE + AN_OPERATION * operations and available()


def available() -> bool:
    """Return whether llvmlite is installed, and not forbidden by TAM570_COMPILED=0; it is not imported for that."""
    return os.environ.get("TAM570_COMPILED") != "0" and importlib.util.find_spec("llvmlite") is not None


Look = Callable[[float, Sequence[float], Sequence[float], int], None]

PYTHON = 300_000  # steps left that are too many: some ten seconds and up
COMPILED = 30_000_000
LOOKS = 20  # in a row
DECAY = 1.5  # h times the fastest decay: accuracy alone asks for less
SWEEPS = 8  # of the power method, enough for a factor of two where one decay is far faster than the rest


def stiffness_watch(
    rhs: Callable[..., Sequence[float]], c: Numbers, origin: float, end: float, sign: float, too_many: int
) -> Look:
    """Return look(t, y, m, steps so far), to be called now and then.

    t, m : the time since `origin`, the scale of each component
    sign : of the engine's clock

    Raises ArithmeticError when the run up to `end` is to be given up.
    """
    before, stiff_looks = (0.0, 0), 0

    def look(t: float, y: Sequence[float], m: Sequence[float], steps: int) -> None:
        nonlocal before, stiff_looks
        (time_before, earlier), before = before, (t, steps)
        if steps == earlier:
            return
        h = (t - time_before) / (steps - earlier)
        stiff = end - t > too_many * h and _decay(rhs, origin + t, y, m, c) * h > DECAY
        stiff_looks = stiff_looks + 1 if stiff else 0
        if stiff_looks >= LOOKS:
            raise ArithmeticError(_advice(sign * (origin + t), h, (end - t) / h))

    return look


def _advice(t: float, h: float, remaining: float) -> str:
    return (
        f"stiff at t = {t:.6g}: stability, not accuracy, keeps the steps at {h:.1g}, and {remaining:.1g} "
        "of them are left. "
        'scipy.integrate.solve_ivp with method="Radau" or method="LSODA" is made for such equations'
    )


def _decay(rhs: Function, t: float, y: Sequence[float], m: Sequence[float], c: Numbers) -> float:
    """Return the rate of the fastest decay, by the power method; 0 if the fastest change is none."""
    rates, along, back = rhs(t, tuple(y), c), [(-1.0 if i % 2 else 1.0) for i in range(len(y))], 0.0
    for _ in range(SWEEPS):
        size = sqrt(sum(a * a for a in along)) / PART
        changed = [v + a / size * scale for v, a, scale in zip(y, along, m, strict=True)]
        moved = rhs(t, tuple(changed), c)
        onward = [_share(b - a, scale) * size for a, b, scale in zip(rates, moved, m, strict=True)]
        fastest = sqrt(sum(b * b for b in onward))
        if not 0 < fastest < 1e300:
            return 0.0
        back = -sum(a * b for a, b in zip(along, onward, strict=True)) / (size * PART * fastest)
        along, rate = onward, fastest / (size * PART)
    return rate if back > 0.9 else 0.0


def _share(x: float, scale: float) -> float:
    return x / scale if scale > NO_SCALE else 0.0
