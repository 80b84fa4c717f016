"""The size by which a component is judged before it has shown one: what starts at zero has a scale all the same.

A component's errors are relative to the largest magnitude that it had so far. What is zero yet takes the size to which
it moves within the first step, on its own or driven by time; else the size that the others give it: the rates change
when these change, each by a part of its own size. What is driven by that in turn takes its size from it, and so on
along a chain. The time that this is given is too short for any component to be turned over by the others, so that a
scale is rather too small than too large: too small costs steps, too large digits.
"""

import math
from collections.abc import Callable, Sequence
from typing import Any

__all__ = ["PART", "UNKNOWN", "magnitudes"]

UNKNOWN = 1e-300  # the magnitude of what is zero and has no scale; never 0, as errors are divided by it
PART = 2.0**-20  # of its own size, by which each component is changed
SHORT = 1e-9  # times h: how long the others are given at least
CALM = 10.0  # times its size: what the others may do to a component with a size

Rates = Callable[[float, Any, Any], Sequence[float]]


def magnitudes(
    rhs: Rates, t: float, h: float, y: Sequence[float], f: Sequence[float], m: Sequence[float], c: Any, later: Any = ()
) -> tuple[float, ...]:
    """(k,) scales; `m` holds those known, UNKNOWN or less the others; `later` times at which a force may set in."""
    known = [max(size, abs(value), _finite(h * rate)) for size, value, rate in zip(m, y, f, strict=True)]
    if min(known) <= UNKNOWN:
        known = _found(rhs, t, h, y, f, known, c, later)
    return tuple(max(size, UNKNOWN) for size in known)


def _found(
    rhs: Rates, t: float, h: float, y: Sequence[float], f: Sequence[float], known: list[float], c: Any, later: Any
) -> list[float]:
    """The sizes, those of zero replaced where the others or the time move them."""
    forces, within, best = [0.0] * len(known), h, known
    for time in (None, *later):
        if time is not None:
            forces = [max(a, _finite(b)) for a, b in zip(forces, rhs(time, y, c), strict=True)]
        spread = None
        while spread is None and within > SHORT * h:
            driven = [size if size > UNKNOWN else within * a for size, a in zip(known, forces, strict=True)]
            spread = _spread(rhs, t, within, y, f, driven, c)
            within = within if spread else within / 4
        best = spread or best
        if min(best) > UNKNOWN:
            break
    return best


def _spread(
    rhs: Rates, t: float, within: float, y: Sequence[float], f: Sequence[float], sizes: list[float], c: Any
) -> list[float] | None:
    """What the sizes do to one another within so many s; None where that turns over one that is known."""
    for _ in range(len(sizes) + 1):
        changed = [v + PART * size * _sign(i) for i, (v, size) in enumerate(zip(y, sizes, strict=True))]
        moved = rhs(t, tuple(changed), c)
        given = [_finite(within * (b - a) / PART) for a, b in zip(f, moved, strict=True)]
        if any(size > UNKNOWN and new > CALM * size for size, new in zip(sizes, given, strict=True)):
            return None
        if not any(size <= UNKNOWN < new for size, new in zip(sizes, given, strict=True)):
            return sizes
        sizes = [size if size > UNKNOWN else new for size, new in zip(sizes, given, strict=True)]
    return sizes


def _sign(i: int) -> float:
    """No two cancel."""
    return (1.0 - 0.15 * (i % 5)) * (-1 if i % 2 else 1)


def _finite(x: float) -> float:
    """|x|, or zero where that is not finite."""
    size: float = abs(x)
    return size if size < math.inf else 0.0
