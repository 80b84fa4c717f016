"""Switches of a right-hand side that is called as it stands: steps end where it may begin to do something else.

After each step the function is evaluated along it (see `course`). What it decides by are its switching functions:
where the first of them passes zero within the step, the step is taken again, to just before that time; the shortest
of all steps then goes across. So no window of time or state is stepped over, and no step is of two pieces. Where a
function cannot be evaluated like this no step is longer than a thousandth of the run.
"""

import math
from collections.abc import Sequence
from functools import partial

import numpy as np

from tam570.integrate.arguments import Array
from tam570.integrate.binding import Rates
from tam570.integrate.course import along
from tam570.values import Numbers

__all__ = ["Switches"]

POINTS = 17  # of a step
X = np.linspace(0.0, 1.0, POINTS)
ENDS = np.array([0.0, 1.0])  # enough for what has not decided anything so far
SHORT = 1e-3  # of the way to a switch: so much shorter is the next step
AT_HAND = 2.0  # times the shortest step
ROUNDED = (1.37, -2.91, 1.82, -5.3)  # units in the last place, by which states are changed: is it more than rounding?
UNSEEN = 1000.0  # steps at least of a run whose switches cannot be seen
NOISE = 16.0  # times that change: what is less has no sign
CHATTER = 60  # switches in a row
MOVES_ON = 1e-4  # of the step that they cut, from one switch to the next: with less the motion does not move on
REACH = 4.0  # tanh(4) is 1 to 7e-4, exp(-4) is 0.02: from twice that on a pulse is seen
EPS = 2.0**-52


class Switches:
    """What is known of the switches of one right-hand side along a run.

    reason : why nothing can be seen of them; empty if it can
    """

    def __init__(self, rates: Rates, size: int, span: float, sign: float) -> None:
        self.span, self.sign = span, sign
        self.profile = along(rates, size)
        self.reason = ""
        self.time, self.distance = math.nan, math.inf  # from the end of the last step to the next switch
        self.pace = self.longest = 0.0  # s, of steps before the last switches, and since
        self.decides = False  # whether it decided by anything so far
        self.is_near = False  # whether the last step was at a switch
        self.crossings: list[float] = []  # times, each soon after the one before

    def reach(self, start: float, h: float, y: Numbers, f: Numbers, c: Numbers) -> float:
        """Return the longest step from here that ends before the next switch, as far as it is known."""
        if self.reason:
            return self.span / UNSEEN
        return self.distance if abs(start - self.time) <= 4 * EPS * abs(start) else math.inf

    def passed(
        self,
        start: float,
        h: float,
        y: Numbers,
        f: Numbers,
        n: Numbers,
        g: Numbers,
        error: float,
        shortest: float,
        c: Numbers,
    ) -> float:
        """Return the length of the part of a step that passes no switch; infinite if all of it passes none.

        The shortest step may pass one: then its own length.
        """
        if self.reason:
            return math.inf
        y, f, n, g = (np.array(v)[:, None] for v in (y, f, n, g))
        if not error <= 1.0:  # the end of a step that is too long tells nothing of its beginning
            n, g = y + h * f, f
        try:
            part, ahead = self._first_switch(start, h, shortest, y, f, n, g)
        except Exception as reason:  # whatever it says to courses, it then gets numbers alone
            self.reason = f"{type(reason).__name__}: {reason}"
            return math.inf
        is_at_switch = h <= 2.0 * shortest
        if is_at_switch:
            self._count(start, y)
        if part > 1.0:
            if error <= 1.0:
                self.is_near = is_at_switch
                self.time, self.longest = start + h, max(self.longest, h)
                closeness = h / max(self.pace, self.longest)  # so much better is the slope known
                self.distance = _just_before(ahead * h, closeness, shortest) if ahead < 1.0 else math.inf
            return math.inf
        if is_at_switch:
            self.is_near = True
            return h
        return _just_before(part * h, 1.0, shortest)

    def _count(self, start: float, y: Numbers) -> None:
        """Count a step at a switch. Raises ArithmeticError where the motion does not leave it."""
        if not self.crossings or start - self.crossings[-1] > self.pace / CHATTER:
            self.crossings, self.pace, self.longest = [], self.longest, 0.0
        self.crossings.append(start)
        if len(self.crossings) > CHATTER and start - self.crossings[-CHATTER] < CHATTER * MOVES_ON * self.pace:
            raise ArithmeticError(
                f"the rates jump to and fro at t = {self.sign * start:.9g}, y = {y.ravel().tolist()}: the motion stays "
                "where they jump. Friction that holds a body at rest has no rate there: stop at an event, or smooth "
                "the jump"
            )

    def _first_switch(
        self, start: float, h: float, shortest: float, y: Array, f: Array, n: Array, g: Array
    ) -> tuple[float, float]:
        """Return the part of the step at which a switch is passed first, and how far beyond its end the next one is.

        In parts of the step; infinite where there is none.
        """
        path = partial(_cubic, h=h, y=y, f=f, n=n, g=g)
        if not self.decides:
            decisions = self.profile(start + ENDS * h, path(ENDS))
            self.decides = bool(decisions.seen or decisions.saturating)
            if not self.decides:
                return math.inf, math.inf
        seen, saturated = self._seen(X, start + X * h, path(X))
        part, ahead = _first_zero(X, seen), _next_zero(seen)
        if 0.0 < part < X[1] or self.is_near:
            near = np.append(0.0, np.geomspace(min(shortest / h, 0.1 * X[1]), X[1], POINTS - 1))
            part = min(_first_zero(near, self._seen(near, start + near * h, path(near))[0]), part)
        elif math.isinf(part) and (turn := _first_turn(seen)):
            x = np.linspace(X[turn - 1], X[turn + 1], POINTS)
            part = _first_zero(x, self._seen(x, start + x * h, path(x))[0])
        return min(part, saturated), ahead

    def _seen(self, x: Array, t: Array, path: Array) -> tuple[Array, float]:
        """(q, m) switching functions, positive at the start; and the part in which nothing saturates unseen."""
        decisions = self.profile(t, path)
        seen = np.array(decisions.seen).reshape(-1, len(x))
        signs = _signs(seen)
        if seen.size and ((signs * seen < 0).any() or not seen[:, 0].all()):
            nearby = self.profile(t, path * (1.0 + EPS * np.resize(ROUNDED, path.shape[::-1]).T))
            if len(nearby.seen) == len(seen):
                noise = np.abs(np.array(nearby.seen) - seen).max(axis=1)
                seen = seen[np.abs(seen).max(axis=1) > NOISE * noise]
                signs = _signs(seen)
        return signs * seen, _saturated(decisions.saturating)


def _just_before(time: float, closeness: float, shortest: float) -> float:
    """Return a step that ends just before a switch; the shortest of all, which goes across, where it is at hand."""
    step = time - max(SHORT * closeness * time, AT_HAND * shortest)
    return step if step > AT_HAND * shortest else shortest


def _cubic(x: Array, h: float, y: Array, f: Array, n: Array, g: Array) -> Array:
    """(k, m) states within a step, by its ends and the derivatives there."""
    z = 1.0 - x
    return y + x * (n - y) + x * z * (z * (h * f - (n - y)) - x * (h * g - (n - y)))


def _signs(seen: Array) -> Array:
    """(q, 1) signs at the start, or the first that is not zero."""
    first = np.argmax(seen != 0.0, axis=1)
    return np.sign(np.take_along_axis(seen, first[:, None], axis=1))


def _first_zero(x: Array, positive: Array) -> float:
    """Return where the first of some functions, positive at the start, passes zero; infinity if none does.

    What is zero at the start, and only there, leaves zero: the derivative at the start may be that of the other side.
    """
    if (x[0] == 0.0) and ((positive[:, 0] == 0.0) & (positive != 0.0).any(axis=1)).any():
        return 0.0
    below = positive < 0.0
    if not below.any():
        return math.inf
    k = int(np.argmax(below.any(axis=0)))
    rows = positive[below[:, k], k - 1 : k + 1]
    return float(x[k - 1] + (x[k] - x[k - 1]) * (rows[:, 0] / (rows[:, 0] - rows[:, 1])).min())


def _first_turn(positive: Array) -> int | None:
    """Return the number of a point near which one of them comes down to zero and turns back, by a parabola."""
    if not positive.size:
        return None
    a, b, c = positive[:, :-2], positive[:, 1:-1], positive[:, 2:]
    curvature = a - 2 * b + c
    with np.errstate(all="ignore"):
        lowest = b - (a - c) ** 2 / (8 * curvature)
    points = np.flatnonzero(((b <= a) & (b <= c) & (curvature > 0) & (lowest < 0.1 * curvature)).any(axis=0))
    return int(points[0]) + 1 if len(points) else None


def _next_zero(positive: Array) -> float:
    """Return how far beyond the end, in steps, the first of them is zero, by its slope there."""
    if not positive.size:
        return math.inf
    slope = (1.5 * positive[:, -1] - 2.0 * positive[:, -2] + 0.5 * positive[:, -3]) * (POINTS - 1)
    with np.errstate(all="ignore"):
        ahead = np.where(slope < 0, -positive[:, -1] / slope, math.inf)
    return float(ahead.min())


def _saturated(arguments: Sequence[Array]) -> float:
    """Return the part of a step in which no argument of exp, tanh and their like changes by itself, or 2 REACH."""
    part = math.inf
    for u in arguments:
        beyond = np.abs(u - u[0]) > 2.0 * max(0.5 * abs(u[0]), REACH)
        if beyond.any():
            part = min(part, float(X[max(int(np.argmax(beyond)) - 1, 1)]))
    return part
