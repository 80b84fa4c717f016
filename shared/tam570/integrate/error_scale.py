"""Error scales of the components at the start, which give the absolute tolerance if the caller gives none.

An error of component i is measured in units of atol_i + rtol |y_i|. If the caller gives no atol, atol_i is a quarter of
rtol times the scale of the component: its size at the start, or its change in the first step if that is larger. If both
are zero, the scale follows from forces that set in later, or from the coupling: the rate changes if the other
components change, each by a fraction of its scale. A component driven by it gets its scale from it, and so on.
The coupling acts for the longest duration in which it changes no component that has a scale by more than CALM times
this scale (tested with changes by a small fraction of the scales and by an eighth); if it never does, for the first
step. So a scale is too small rather than too large: too small costs steps, too large costs digits. A component that is
smaller than the round-off of what drives it counts as zero.

Rates that are mostly round-off, as 1 - cos(1e-6 t) at first, tell no size: if the scale follows from them, atol_i is
at least the computed bound of the round-off in the first step.

A component that starts at zero may be moved by a pulse that begins later, at 1e-300, or that lies between such times.
If round-off then allows no step, its scale grows to the size to which this pulse moves it.
"""

import math
from collections.abc import Callable, Sequence

from tam570.values import Numbers

SHARE = 0.25  # atol over rtol times the scale: at a zero, the tolerance is a fifth of that at the start
NO_SCALE = 1e-290  # scale of a component that is zero and that nothing moves; not 0, because errors are divided by it
EPS = 2.0**-52
PART = 2.0**-20  # change of each component to test the coupling, as a fraction of its scale
COARSE = 0.125  # the same, to detect scales so large that the rates are no longer linear in the change
LONG, SHORT = 4096.0, 1e-9  # longest and shortest duration of the coupling, in units of h
SOONEST = 1e-15  # part of the run after which a force is sought first
BISECTIONS = 12  # to find when a force sets in
CALM = 4.0  # largest change by coupling of a component that has a scale, in units of this scale

Floats = Sequence[float]
Rates = Callable[[float, Numbers, Numbers], Floats]


def error_scale(
    rhs: Rates, t: float, h: float, y: Floats, f: Floats, c: Numbers, later: Numbers = ()
) -> tuple[float, ...]:
    """Return (k,) scales at the start. h : s, first step; later : times at which a force may have set in."""
    own_sizes = [max(abs(value), _finite(h * rate)) for value, rate in zip(y, f, strict=True)]
    if min(own_sizes) <= NO_SCALE:
        driven = _driven_sizes(rhs, t, h, y, f, own_sizes, c, later)
        own_sizes = [max(size, own_size) for size, own_size in zip(driven, own_sizes, strict=True)]
    return tuple(max(size, NO_SCALE) for size in own_sizes)


def _driven_sizes(
    rhs: Rates, t: float, h: float, y: Floats, f: Floats, own_sizes: list[float], c: Numbers, later: Numbers
) -> list[float]:
    """Return the scales; those that are zero are estimated from the coupling and from forces at later times."""
    base = rhs(t, y, c)  # f is without ramps
    moved = _moved_by(rhs, t, h, y, base, own_sizes, c)
    sizes = [0.0 if size < EPS * most else size for size, most in zip(own_sizes, moved, strict=True)]
    forces, duration, best = [0.0] * len(sizes), LONG * h, sizes
    for time in (None, *later):
        if time is not None:
            forces = [max(a, _finite(b)) for a, b in zip(forces, rhs(time, y, c), strict=True)]
        spread = None
        while spread is None and duration > SHORT * h:
            moved = [max(size, h * a) for size, a in zip(sizes, forces, strict=True)]
            spread = _spread(rhs, t, duration, y, f, base, moved, c)
            if duration == LONG * h and spread:  # the coupling is weak
                duration, spread = h, None
            else:
                duration = duration if spread else duration / 4
        best = spread or best
        if min(best) > NO_SCALE:
            break
    return best


def grown_scale(
    rhs: Rates, t: float, end: float, y: Floats, sizes: Floats, may_grow: Sequence[bool], c: Numbers
) -> list[float]:
    """Return (k,) scales if a force sets in after t and before `end`; `sizes`, the scales at t, if none does.

    A force sets in if the rate of a component that may grow becomes LONG times larger, and so does its size. The force
    counts at the first time after which it grows no further, of times each four times as far from t as the last.
    """
    base, h, until, forces = rhs(t, y, c), max(2.0**-50 * abs(t), SOONEST * (end - t)), 0.0, [0.0] * len(y)
    limits = [LONG * abs(rate) if grows else math.inf for rate, grows in zip(base, may_grow, strict=True)]

    def forces_at(h: float) -> list[float]:
        each = zip(map(_finite, rhs(t + h, y, c)), limits, sizes, strict=True)
        return [rate if rate > limit and h * rate > LONG * size else 0.0 for rate, limit, size in each]

    while t + h < end:
        later = forces_at(h)
        if any(new > force for new, force in zip(later, forces, strict=True)):
            until, forces = h, later
        elif until:
            break
        h *= 4.0
    if not until:
        return list(sizes)
    low, high = until / 4.0, until  # the force was a small part of this
    for _ in range(BISECTIONS):
        h = (low + high) / 2.0
        is_on = any(0.0 < force < LONG * new for new, force in zip(forces_at(h), forces, strict=True))
        low, high = (low, h) if is_on else (h, high)
    duration, driven = until - low, None
    own_sizes = [duration * a if grows else size for a, size, grows in zip(forces, sizes, may_grow, strict=True)]
    f = [0.0 if grows else rate for rate, grows in zip(base, may_grow, strict=True)]
    while driven is None and duration > SHORT * until:
        driven, duration = _spread(rhs, t, duration, y, f, base, own_sizes, c), duration / 4.0
    each = zip(sizes, driven or sizes, may_grow, strict=True)
    return [new if grows and new > CALM * size else size for size, new, grows in each]


def _spread(
    rhs: Rates, t: float, duration: float, y: Floats, f: Floats, base: Floats, own_sizes: list[float], c: Numbers
) -> list[float] | None:
    """Return scales by coupling for `duration`, s; None if it changes a scale that is not zero too much."""
    sizes = [
        max(size, _finite(duration * rate)) if size > NO_SCALE else size
        for size, rate in zip(own_sizes, f, strict=True)
    ]
    is_own = [size > NO_SCALE for size in sizes]
    for _ in range(len(sizes) + 1):
        moved = _moved_by(rhs, t, duration, y, base, sizes, c)
        grows = [new > max(CALM * size, NO_SCALE) for size, new in zip(sizes, moved, strict=True)]
        if any(is_fixed and more for is_fixed, more in zip(is_own, grows, strict=True)):
            return None
        if not any(grows):
            break
        sizes = [new if more else size for size, new, more in zip(sizes, moved, grows, strict=True)]
    coarse = _moved_by(rhs, t, duration, y, base, sizes, c, COARSE)
    if any(size > NO_SCALE and not new <= CALM * size for size, new in zip(sizes, coarse, strict=True)):
        return None
    return [size if size > NO_SCALE else new for size, new in zip(own_sizes, sizes, strict=True)]


def _moved_by(
    rhs: Rates, t: float, duration: float, y: Floats, f: Floats, sizes: Floats, c: Numbers, part: float = PART
) -> list[float]:
    """Return the change of each component in `duration`, s, if all change by their sizes; scaled up from `part`."""
    signs = [(1.0 - 0.15 * (i % 5)) * (-1 if i % 2 else 1) for i in range(len(y))]  # unequal, so that no two cancel
    changed = [v + part * size * sign for v, size, sign in zip(y, sizes, signs, strict=True)]
    moved = [abs(duration * (b - a) / part) for a, b in zip(f, rhs(t, tuple(changed), c), strict=True)]
    return [_finite(new) for new in moved] if part == PART else moved


def _finite(x: float) -> float:
    """Return |x|, or zero if x is not finite."""
    size: float = abs(x)
    return size if size < math.inf else 0.0
