"""Switches of a right-hand side that is called as it stands: steps end where it may begin to do something else.

What the function decides by (see `course`) are its switching functions, evaluated along each step: where the first of
them passes zero the step is taken again, to just before that time; the shortest of all steps then goes across. So no
window of time or state is stepped over, and no step is of two pieces. Where a function cannot be looked into like this
no step is longer than a thousandth of the run.
"""

import math
from collections.abc import Callable, Sequence
from functools import partial

import numpy as np

from tam570.integrate.arguments import Array
from tam570.integrate.course import Course, along
from tam570.integrate.dop853 import REACH
from tam570.integrate.rates import Rates
from tam570.integrate.watch import chatter
from tam570.values import Numbers

POINTS, ZOOMS = 17, 5  # of a step; how often a part of it is looked at closer
X = np.linspace(0.0, 1.0, POINTS)
SHORT = 1e-3  # of the way to a switch: so much shorter is the next step
AT_HAND = 2.5  # times the shortest step: by no whole number of them, lest one end at the switch itself
ROUNDED = (1.37, -2.91, 1.82, -5.3)  # units in the last place, by which states are changed: is it more than rounding?
UNSEEN = 1000.0  # steps at least of a run whose switches cannot be seen
NOISE = 16.0  # times that change: what is less has no sign
CHATTER = 60  # switches in a row
LEAVING = 200  # points of a step from a switch
SAME_TIME = 1.0 - 1e-6  # of what time alone decides
SAME, SOON = 30.0, 1e-5  # of the tolerance: rates that change by less move no digit; of a run: from switch to switch
NEAR = 1e-9  # of a state: what it changes in a switching function is zero
MOVES_ON = 1e-4  # of the step that they cut, from one switch to the next: with less the motion does not move on
EPS = 2.0**-52


def _basis(x: Array) -> Array:
    """(3, m) weights at parts x of a step: of the whole move, and of h times the derivatives at both ends."""
    z = 1.0 - x
    return np.array([x * (1.0 + z * (x - z)), x * z * z, -x * x * z])


BASIS = _basis(X)
DIFFERENCES = np.diff(np.eye(POINTS), 2, axis=0).T  # of neighbouring points, and the slope at the end of the step
DIFFERENCES = np.column_stack([DIFFERENCES, (POINTS - 1) * np.r_[np.zeros(POINTS - 3), 0.5, -2.0, 1.5]])


class Switches:
    """What is known of the switches of one right-hand side along a run.

    reason : why nothing can be seen of them; opaque : a function in which some may be; empty if there is none
    """

    def __init__(self, rates: Rates, size: int, span: float, sign: float) -> None:
        self.span, self.sign = span, sign
        self.profile = along(rates, size)
        self.begin(0.0)

    def begin(self, rtol: float) -> None:
        """Forget the run before."""
        self.same = SAME * rtol
        self.reason = self.opaque = ""
        self.is_smooth = False  # whether it decides nothing
        self.time, self.distance = math.nan, math.inf  # from the end of the last step to the next switch
        self.expected = -math.inf  # when that is passed
        self.pace = self.longest = 0.0  # s, of steps before the last switches, and since
        self.decisions: Course | None = None  # what it decided by last
        self.signs = np.empty((0, 1))  # of that, at the start of the step
        self.is_near = False  # whether the last step was at a switch
        self.may_keep = self.is_accepted = False  # of the step: whether what is zero at its ends is zero inside
        self.leaving = 0.0  # s, until the state is another than at a start at a switch
        self.is_line = np.empty(0, dtype=bool)  # of what decides in a step: whether it is affine in time alone
        self.crosses_unseen = False  # whether the step crosses a switch within rounding, or a state's errors
        self.crossings: list[float] = []  # times, each soon after the one before
        self.passages = 0  # of switches so far
        self.idle: list[float] = []  # times of switches at which the rates do not jump

    def reach(self, start: float, h: float, y: Numbers, f: Numbers, c: Numbers) -> float:
        """Return the longest step from here that ends before the next switch, as far as it is known."""
        distance = self.distance if abs(start - self.time) <= 4 * EPS * abs(start) else math.inf
        return min(distance, self.span / UNSEEN) if self.unseen_reason else distance

    @property
    def unseen_reason(self) -> str:
        """Why steps are at most a thousandth of the run."""
        return self.reason or self.opaque and f"nobody can see where {self.opaque} switches"

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
        if self.reason or self.is_smooth:
            return math.inf
        moves = np.array((n, f, g)) if error <= 1.0 else np.array((f, f, f))  # of a step too long the end tells nothing
        moves[1:] *= h
        moves[0] = moves[0] - y if error <= 1.0 else moves[1]
        try:
            path = np.array(y)[:, None], moves.T
            self.may_keep, self.is_accepted = h > 2.0 * shortest, error <= 1.0
            self.crosses_unseen = False
            part, ahead, is_exact = self._first_switch(start, h, shortest, *path)
            if part == 0.0 and not self.leaving:
                self.leaving = self._leave(start, h, shortest, *path)
        except Exception as reason:  # whatever it says to courses, it then gets numbers alone
            self.reason = f"{type(reason).__name__}: {reason}"
            part, ahead, is_exact = math.inf, math.inf, False
        if self.unseen_reason and 2.0 * self.span / UNSEEN < min(part, 1.0) * h:
            return self.span / UNSEEN
        shortest = max(shortest, self.leaving)
        is_at_switch = h <= 2.0 * shortest
        self.leaving *= error > 1.0
        if is_at_switch and part <= 1.0 or self.crosses_unseen and error <= 1.0:
            self._count(start, y, f, g)
        if part > 1.0:
            if error <= 1.0:
                self.is_near = is_at_switch
                self.time, self.longest = start + h, max(self.longest, h)
                closeness = 0.0 if is_exact else h / max(self.pace, self.longest)  # so much better is the slope known
                self.distance = shortest if is_at_switch and self.time <= self.expected + shortest else math.inf
                if ahead < 1.0 and not is_at_switch:
                    self.expected = self.time + ahead * h
                    self.distance = _just_before(ahead * h, closeness, max(shortest, 4.0 * EPS * abs(self.expected)))
            return math.inf
        if is_at_switch:
            self.is_near, self.expected, self.distance = True, -math.inf, math.inf
            return h
        self.expected = start + part * h
        return _just_before(part * h, 0.0 if is_exact else 1.0, max(shortest, 4.0 * EPS * abs(self.expected)))

    def _count(self, start: float, y: Numbers, f: Numbers, g: Numbers) -> None:
        """Count a step at a switch. Raises ArithmeticError where the motion does not leave it.

        Where the rates stay the same across many, they are asked no more: whether an iteration has converged, it
        decides anew all the time.
        """
        self.passages += 1
        if all(abs(a - b) <= self.same * max(abs(a), abs(b)) for a, b in zip(f, g, strict=True)):
            self.idle.append(start)
            if len(self.idle) > CHATTER and start - self.idle[-CHATTER] < CHATTER * SOON * self.span:
                self.reason = f"it switches all the time, from t = {self.sign * start:.9g}, and its rates stay the same"
            return
        if not self.crossings or start - self.crossings[-1] > self.pace / CHATTER:
            self.crossings, self.pace, self.longest = [], max(self.longest, NEAR * self.span), 0.0
        self.crossings.append(start)
        if len(self.crossings) > CHATTER and start - self.crossings[-CHATTER] < CHATTER * MOVES_ON * self.pace:
            raise chatter(self.sign * start, y)

    def _first_switch(
        self, start: float, h: float, shortest: float, y: Array, moves: Array
    ) -> tuple[float, float, bool]:
        """Return the part of the step at which a switch is passed first, and how far beyond its end the next one is.

        In parts of the step; infinite where there is none. And whether time alone decides there, so that it is exact.
        """
        look = partial(self._look, start, h, y, moves)
        positive, saturated = look(X, BASIS)
        if not len(positive):
            return saturated, math.inf, False
        is_line = self.is_line
        part, differences = _first_zero(X, positive), positive @ DIFFERENCES
        if 0.0 < part < X[1] or self.is_near or (positive[:, 0] < SHORT * positive[:, 1]).any():
            near = np.append(0.0, X[1] * min(shortest / h / X[1], 0.1) ** X[:0:-1])
            closer = _first_zero(near, look(near, _basis(near))[0])
            part = closer if closer < math.inf else part
        if math.isinf(part):
            part = _first_dip(positive, look)
        part = min(part, saturated)
        zeros = zip(positive[:, -1].tolist(), differences[:, -1].tolist(), strict=True)
        ahead = min((-end / rate for end, rate in zeros if rate < 0), default=math.inf)
        lines = zip(positive[is_line, 0].tolist(), positive[is_line, -1].tolist(), strict=True)
        exact = min((first / (first - end) for first, end in lines if end < first), default=math.inf)
        if exact <= 1.0 and part >= SAME_TIME * exact > 0.0:
            return exact, ahead, True
        if exact >= 1.0 and ahead >= SAME_TIME * (exact - 1.0) and part > 1.0:
            return part, exact - 1.0, True
        return part, ahead, False

    def _leave(self, start: float, h: float, shortest: float, y: Array, moves: Array) -> float:
        """Return after how many s no switching function is zero as at the start: a state of 1 moves by no 1e-30."""
        x = np.append(0.0, np.geomspace(min(shortest / h, 1.0), 1.0, LEAVING))
        seen = np.array(self.decisions.evaluate(start + x * h, y + moves @ _basis(x))[0]) if self.decisions else y[:0]
        leaving = seen[(seen[:, 0] == 0.0) & (seen != 0.0).any(axis=1)] != 0.0
        time = 2.0 * h * float(x[np.argmax(leaving.all(axis=0))])
        return time if time > CHATTER * shortest else shortest

    def _look(self, start: float, h: float, y: Array, moves: Array, x: Array, basis: Array) -> tuple[Array, float]:
        """(q, m) switching functions, positive at the start; and the part in which nothing saturates unseen."""
        t, path = start + x * h, y + moves @ basis
        seen, saturating = self.decisions.evaluate(t, path) if self.decisions else ([], [])
        rows = np.array(seen).reshape(-1, len(x))
        positive = self.signs * rows
        if not self.decisions or not (positive > 0.0).all() and (_signs(rows) != self.signs).any():
            self.decisions = self.profile(t, path)
            seen, saturating = self.decisions.evaluate(t, path)
            rows = np.array(seen).reshape(-1, len(x))
            self.signs, self.opaque = _signs(rows), self.opaque or self.decisions.opaque
            positive = self.signs * rows
            self.is_smooth = not seen and not saturating
        self.is_line = self.decisions.is_line if x is X else self.is_line
        if not (positive > 0.0).all():
            nearby = self.decisions.evaluate(t, path * (1.0 + EPS * np.resize(ROUNDED, path.shape[::-1]).T))[0]
            noise = np.abs(self.signs * nearby - positive).max(axis=1)
            near = NEAR / EPS * noise
            turns = np.abs(positive[:, 2]) > 3.0 * np.abs(positive[:, 1])  # twice a linear one, four times a square
            is_kept = (np.abs(positive[:, 0]) <= near) & np.where(
                self.is_accepted, np.abs(positive[:, -1]) <= near, turns
            )
            is_noise = np.abs(positive).max(axis=1) <= NOISE * noise
            is_left_out = is_noise | is_kept & self.may_keep
            if x is X:
                left_out = positive[is_left_out]
                self.is_line = self.is_line[~is_left_out]
                self.crosses_unseen = bool(((left_out[:, 0] > 0.0) & (left_out[:, -1] <= 0.0)).any())
            positive = positive[~is_left_out]
        return positive, _saturated(saturating) if saturating else math.inf


def _just_before(time: float, closeness: float, shortest: float) -> float:
    """Return a step that ends just before a switch; the shortest of all, which goes across, where it is at hand."""
    step = time - max(SHORT * closeness * time, AT_HAND * shortest)
    return step if step > AT_HAND * shortest else shortest


def _signs(seen: Array) -> Array:
    """(q, 1) signs at the start, or the first that is not zero."""
    first = np.argmax(seen != 0.0, axis=1)
    signs: Array = np.sign(seen[np.arange(len(seen)), first])
    return signs[:, None]


def _first_zero(x: Array, positive: Array) -> float:
    """Return where the first of some functions, positive at the start, passes zero; infinity if none does.

    What is zero at the start, and only there, leaves zero: the derivative at the start may be that of the other side.
    """
    if (positive > 0.0).all():
        return math.inf
    below = positive < 0.0
    if not below.any():
        leaves = x[0] == 0.0 and ((positive[:, 0] == 0.0) & (positive != 0.0).any(axis=1)).any()
        return 0.0 if leaves else math.inf
    k = int(np.argmax(below.any(axis=0)))
    rows = positive[below[:, k], k - 1 : k + 1]
    return float(x[k - 1] + (x[k] - x[k - 1]) * (rows[:, 0] / (rows[:, 0] - rows[:, 1])).min())


def _first_dip(positive: Array, look: Callable[[Array, Array], tuple[Array, float]]) -> float:
    """Return where the first of them passes zero between two of the points X, to come back before the next.

    It is looked at ever closer to where it may turn, until it has passed or no parabola reaches zero.
    """
    for turn in _turns(positive):
        x, turns = X, [turn]
        for _ in range(ZOOMS):
            if not turns:
                break
            x = np.linspace(x[turns[0] - 1], x[turns[0] + 1], POINTS)
            nearby = look(x, _basis(x))[0]
            if (part := _first_zero(x, nearby)) < math.inf:
                return part
            turns = _turns(nearby)
    return math.inf


def _turns(positive: Array) -> list[int]:
    """Return the numbers of the points near which one of them comes down to zero and turns back, by a parabola."""
    curvature = positive @ DIFFERENCES[:, :-1]
    a, b, c = positive[:, :-2], positive[:, 1:-1], positive[:, 2:]
    if (np.minimum(b, c) > 0.225 * curvature).all():
        return []
    with np.errstate(all="ignore"):
        lowest = b - (a - c) ** 2 / (8 * curvature)
    turning = (b <= a) & (b <= c)
    turning[:, -1] |= (c < b)[:, -1] & (a + 3.0 * c > 4.0 * b)[:, -1]  # it rises at the end: between the last two
    points = np.flatnonzero((turning & (curvature > 0) & (lowest < 0.1 * curvature)).any(axis=0))
    turns: list[int] = (points + 1).tolist()
    return turns


def _saturated(arguments: Sequence[Array]) -> float:
    """Return the part of a step in which no argument of exp, tanh and their like changes by itself, or 2 REACH."""
    part = math.inf
    for u in arguments:
        beyond = np.abs(u - u[0]) > 2.0 * max(0.5 * abs(u[0]), REACH)
        if beyond.any():
            part = min(part, float(X[max(int(np.argmax(beyond)) - 1, 1)]))
    return part
