"""The absolute tolerance that a start implies: what is zero has a scale all the same.

An error of component i is judged by atol_i + rtol |y_i|. Where the caller gives no atol, atol_i is a quarter of rtol
times the size of the component at the start. What is zero there takes the size to which it moves within the first
step, on its own or driven by time; else the size that the others give it: the rates change when these change, each by a
part of its own size. What is driven by that in turn takes its size from it, and so on along a chain.
The time that this is given is that in which the known turn each other over, no longer, when all change by their sizes
(tried at a small part and at an eighth of them): so a scale is rather too small than too large. Too small costs steps,
too large digits. Where nothing turns over, the time is the first step. What is smaller than the rounding of what drives
it is zero here.
"""

import math
from collections.abc import Callable, Sequence

from tam570.values import Numbers

SHARE = 0.25  # of rtol times the size: a component that passes zero is judged four times as strictly as at the start
NO_SCALE = 1e-290  # of what is zero, and moved by nothing; never 0, as errors are divided by it
EPS = 2.0**-52
PART = 2.0**-20  # of its own size, by which each component is changed
COARSE = 0.125  # the same, to see that sizes are not so large that the rates are others
LONG, SHORT = 4096.0, 1e-9  # times h: how long the others are given at most and at least
CALM = 4.0  # times its size: what the others may do to a component with a size

Floats = Sequence[float]
Rates = Callable[[float, Numbers, Numbers], Floats]


def error_scale(
    rhs: Rates, t: float, h: float, y: Floats, f: Floats, c: Numbers, later: Numbers = ()
) -> tuple[float, ...]:
    """(k,) sizes at the start; `later` are times at which a force may set in."""
    own_sizes = [max(abs(value), _finite(h * rate)) for value, rate in zip(y, f, strict=True)]
    if min(own_sizes) <= NO_SCALE:
        driven = _driven_sizes(rhs, t, h, y, f, own_sizes, c, later)
        own_sizes = [max(size, own_size) for size, own_size in zip(driven, own_sizes, strict=True)]
    return tuple(max(size, NO_SCALE) for size in own_sizes)


def _driven_sizes(
    rhs: Rates, t: float, h: float, y: Floats, f: Floats, own_sizes: list[float], c: Numbers, later: Numbers
) -> list[float]:
    """Return the sizes, those of zero replaced where the others or the time move them."""
    moved = _moved_by(rhs, t, h, y, f, own_sizes, c)
    sizes = [0.0 if size < EPS * most else size for size, most in zip(own_sizes, moved, strict=True)]
    forces, duration, best = [0.0] * len(sizes), LONG * h, sizes
    for time in (None, *later):
        if time is not None:
            forces = [max(a, _finite(b)) for a, b in zip(forces, rhs(time, y, c), strict=True)]
        spread = None
        while spread is None and duration > SHORT * h:
            moved = [max(size, h * a) for size, a in zip(sizes, forces, strict=True)]
            spread = _spread(rhs, t, duration, y, f, moved, c)
            if duration == LONG * h and spread:  # nothing turns over
                duration, spread = h, None
            else:
                duration = duration if spread else duration / 4
        best = spread or best
        if min(best) > NO_SCALE:
            break
    return best


def _spread(
    rhs: Rates, t: float, duration: float, y: Sequence[float], f: Sequence[float], own_sizes: list[float], c: Numbers
) -> list[float] | None:
    """Return what the sizes do to one another within so many s; None where that turns over one that is known."""
    sizes = [
        max(size, _finite(duration * rate)) if size > NO_SCALE else size
        for size, rate in zip(own_sizes, f, strict=True)
    ]
    is_own = [size > NO_SCALE for size in sizes]
    for _ in range(len(sizes) + 1):
        moved = _moved_by(rhs, t, duration, y, f, sizes, c)
        grows = [new > max(CALM * size, NO_SCALE) for size, new in zip(sizes, moved, strict=True)]
        if any(is_fixed and more for is_fixed, more in zip(is_own, grows, strict=True)):
            return None
        if not any(grows):
            break
        sizes = [new if more else size for size, new, more in zip(sizes, moved, grows, strict=True)]
    coarse = _moved_by(rhs, t, duration, y, f, sizes, c, COARSE)
    if any(size > NO_SCALE and not new <= CALM * size for size, new in zip(sizes, coarse, strict=True)):
        return None
    return [size if size > NO_SCALE else new for size, new in zip(own_sizes, sizes, strict=True)]


def _moved_by(
    rhs: Rates, t: float, duration: float, y: Floats, f: Floats, sizes: Floats, c: Numbers, part: float = PART
) -> list[float]:
    """To what each is moved within so many s when all change by their sizes, in proportion to a part of these."""
    signs = [(1.0 - 0.15 * (i % 5)) * (-1 if i % 2 else 1) for i in range(len(y))]  # no two cancel
    changed = [v + part * size * sign for v, size, sign in zip(y, sizes, signs, strict=True)]
    moved = [abs(duration * (b - a) / part) for a, b in zip(f, rhs(t, tuple(changed), c), strict=True)]
    return [_finite(new) for new in moved] if part == PART else moved


def _finite(x: float) -> float:
    """|x|, or zero where that is not finite."""
    size: float = abs(x)
    return size if size < math.inf else 0.0
