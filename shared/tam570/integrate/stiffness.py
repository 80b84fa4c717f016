"""Whether a run will never end because its equations are stiff: told in time, with what to do about it.

An explicit method takes steps no longer than the fastest decay allows, however smooth the motion. A run is given up
when that holds at twenty looks in a row, and far more steps are left than anybody waits for.
"""

from collections.abc import Callable, Sequence
from math import sqrt

from tam570.integrate.error_scale import NO_SCALE, PART
from tam570.values import Function, Numbers

__all__ = ["COMPILED", "PYTHON", "Look", "stiffness_watch"]

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
