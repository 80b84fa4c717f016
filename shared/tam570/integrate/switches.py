"""Locates switches of a right-hand side that is called, so that steps end where it may change its formulas.

The quantities on which its decisions depend (see `course`) are switching functions, evaluated along each step. If one
crosses zero, the step is repeated to end just before the first crossing; the shortest possible step then crosses it. So
no step jumps over a window of time or state, and none combines two pieces.

If a function cannot be analyzed like this, it is evaluated along each step, at points no farther apart than a
thousandth of the run. A polynomial follows smooth rates from point to point; if a rate is off by more than the
tolerance allows over the distance of two points, the step is repeated in steps of at most this distance. So a pulse
that is as long as a thousandth of the run is seen, and so is a jump; a shorter pulse may lie between two points.
"""

import math
from collections.abc import Callable, Sequence
from functools import partial

import numpy as np

from tam570.integrate.arguments import Array
from tam570.integrate.course import Course, along
from tam570.integrate.dop853 import REACH
from tam570.integrate.rates import TRIAL_ERRORS, CalledRates
from tam570.integrate.trace import refusal_of
from tam570.integrate.watch import chatter
from tam570.values import Numbers

POINTS, ZOOMS = 17, 5  # points of a step; refinements near a minimum, at most
X = np.linspace(0.0, 1.0, POINTS)
SHORT = 1e-3  # margin before a switch, as a fraction of the distance
AT_HAND = 2.5  # smallest margin, in shortest steps; not an integer, so that no step ends exactly at the switch
ROUNDED = (1.37, -2.91, 1.82, -5.3)  # units in the last place; changes of the state that reveal round-off
UNSEEN = 1000.0  # points, at least, of a run whose switches cannot be detected
FEWEST = 12  # distances of these points in a step, at least
ORDER, WEIGHT = 8, 8.0  # of the differences of rates, at most 0.01 tolerances if smooth; weight of the second point
NOISE = 16.0  # size below which a switching function has no sign, in units of its round-off
CHATTER = 60  # consecutive switches
LEAVING = 200  # sample points in a step that starts at a switch
SAME_TIME = 1.0 - 1e-6  # a switch by time alone comes first if no other is earlier than this part of its distance
SAME, SOON = 30.0, 1e-5  # tolerances: smaller changes of rates are none; of a run: mean time between idle switches
NEAR = 1e-9  # relative change of a state; its effect on a switching function counts as zero
MOVES_ON = 1e-4  # mean time between switches that is too short, as a fraction of the steps before them
EPS = 2.0**-52


def _basis(x: Array) -> Array:
    """Return (3, m) weights at fractions x of a step: of the change over it, and of h times the rates at both ends."""
    z = 1.0 - x
    return np.array([x * (1.0 + z * (x - z)), x * z * z, -x * x * z])


BASIS = _basis(X)
DIFFERENCES = np.diff(np.eye(POINTS), 2, axis=0).T  # second differences, and slope at the end of the step
DIFFERENCES = np.column_stack([DIFFERENCES, (POINTS - 1) * np.r_[np.zeros(POINTS - 3), 0.5, -2.0, 1.5]])


class Switches:
    """Tracks the switches of a right-hand side along a run.

    reason : why they cannot be detected; opaque : a function that may contain some; both are empty if all is well
    """

    def __init__(self, rates: CalledRates, span: float, sign: float) -> None:
        self.rates, self.span, self.sign = rates, span, sign
        self.profile = along(rates.rates, rates.size)
        self.begin(0.0)

    def begin(self, rtol: float) -> None:
        """Reset for a new run."""
        self.same = SAME * rtol
        self.reason = self.opaque = ""
        self.is_smooth = False  # whether the function makes no decisions
        self.rtol, self.short_until = rtol, -math.inf  # s, end of a step that may hide a pulse
        self.time, self.distance = math.nan, math.inf  # end of the last step, and s from there to the next switch
        self.expected = -math.inf  # s, estimated time of that switch
        self.pace = self.longest = 0.0  # s, longest steps before the last switches, and since
        self.decisions: Course | None = None  # the last decisions
        self.signs = np.empty((0, 1))  # of the switching functions, at the start of the step
        self.is_near = False  # whether the last step was at a switch
        self.may_keep = self.is_accepted = False  # of the step: can functions with zeros at both ends be ignored?
        self.leaving = 0.0  # s, step that leaves a start on a switch
        self.is_line = np.empty(0, dtype=bool)  # whether each switching function is affine in time alone
        self.crosses_unseen = False  # whether the step crosses a switch within the errors of the state
        self.crossings: list[float] = []  # times of switches in quick succession
        self.passages = 0  # number of switches so far
        self.idle: list[float] = []  # times of switches without a jump of the rates

    def reach(self, start: float, h: float, y: Numbers, f: Numbers, c: Numbers) -> float:
        """Return the longest step, s, that ends before the next switch, as far as it can be predicted."""
        distance = self.distance if abs(start - self.time) <= 4 * EPS * abs(start) else math.inf
        return min(distance, self.span / UNSEEN) if start < self.short_until else distance

    @property
    def unseen_reason(self) -> str:
        """Why switches cannot be detected; empty if they can."""
        return self.reason or self.opaque and f"nobody can see where {self.opaque} switches"

    def passed(
        self,
        start: float,
        h: float,
        y: Numbers,
        f: Numbers,
        n: Numbers,
        g: Numbers,
        a: Numbers,
        error: float,
        shortest: float,
        c: Numbers,
    ) -> float:
        """Return how long a step, s, may be to cross no switch; infinite if it crosses none.

        The shortest step may cross one: then return its length.
        """
        if self.reason or self.is_smooth:
            return self._pulse_free(start, h, y, f, n, g, a, error)
        moves = np.array((n, f, g)) if error <= 1.0 else np.array((f, f, f))  # the end of a refused step is not used
        moves[1:] *= h
        moves[0] = moves[0] - y if error <= 1.0 else moves[1]
        try:
            path = np.array(y)[:, None], moves.T
            self.may_keep, self.is_accepted = h > 2.0 * shortest, error <= 1.0
            self.crosses_unseen = False
            part, ahead, is_exact = self._first_switch(start, h, shortest, *path)
            if part == 0.0 and not self.leaving:
                self.leaving = self._leave(start, h, shortest, *path)
        except Exception as reason:  # a function that fails with symbols is called with numbers only
            self.reason = refusal_of(reason)
            part, ahead, is_exact = math.inf, math.inf, False
        if part > 1.0 and (limit := self._pulse_free(start, h, y, f, n, g, a, error)) < h:
            return limit
        shortest = max(shortest, self.leaving)
        is_at_switch = h <= 2.0 * shortest
        self.leaving *= error > 1.0
        if is_at_switch and part <= 1.0 or self.crosses_unseen and error <= 1.0:
            self._count(start, y, f, g)
        if part > 1.0:
            if error <= 1.0:
                self.is_near = is_at_switch
                self.time, self.longest = start + h, max(self.longest, h)
                closeness = 0.0 if is_exact else h / max(self.pace, self.longest)  # a short step predicts better
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

    def _pulse_free(
        self, start: float, h: float, y: Numbers, f: Numbers, n: Numbers, g: Numbers, a: Numbers, error: float
    ) -> float:
        """Return how long an accepted step, s, may be to hide no pulse, by its rates at points along a cubic."""
        longest = self.span / UNSEEN
        if not self.unseen_reason or error > 1.0 or h <= 2.0 * longest:
            return math.inf
        x = np.linspace(0.0, 1.0, max(FEWEST, math.ceil(h / longest)) + 1)
        first, last = np.array(y), np.array(n)
        path = first[:, None] + np.array((last - first, h * np.array(f), h * np.array(g))).T @ _basis(x)
        tolerance = np.array(a) + self.rtol * np.maximum(np.abs(first), np.abs(last))
        try:
            points = zip((start + h * x).tolist()[1:-1], path.T.tolist()[1:-1], strict=True)
            sampled = [self.rates(*point) for point in points]
            if (_pulses(np.array([f, *sampled, g])) * h * x[1] <= tolerance).all():
                return math.inf
        except TRIAL_ERRORS:
            pass  # the shorter steps tell whether the solution leads there
        self.short_until = start + h
        return longest

    def _count(self, start: float, y: Numbers, f: Numbers, g: Numbers) -> None:
        """Count a step across a switch; raise ArithmeticError if the motion does not leave it.

        If the rates stay the same across many switches, no longer track them: an iteration until convergence, for
        example, makes new decisions all the time.
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
        """Return the position of the first switch in the step, and the distance of the next one from its end.

        Both are fractions of the step, infinite if there is none. Also return whether the switch depends only on time,
        so that its time is exact.
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
        """Return the step, s, after which all switching functions that start at zero have left it despite round-off."""
        x = np.append(0.0, np.geomspace(min(shortest / h, 1.0), 1.0, LEAVING))
        seen = np.array(self.decisions.evaluate(start + x * h, y + moves @ _basis(x))[0]) if self.decisions else y[:0]
        leaving = seen[(seen[:, 0] == 0.0) & (seen != 0.0).any(axis=1)] != 0.0
        time = 2.0 * h * float(x[np.argmax(leaving.all(axis=0))])
        return time if time > CHATTER * shortest else shortest

    def _look(self, start: float, h: float, y: Array, moves: Array, x: Array, basis: Array) -> tuple[Array, float]:
        """Return (q, m) switching functions times their signs at the start, and the fraction from `_saturated`."""
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
            turns = np.abs(positive[:, 2]) > 3.0 * np.abs(positive[:, 1])  # ratio 2 if linear, 4 if quadratic
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


def _pulses(rates: Array) -> Array:
    """Return (k,) areas of pulses in (m, k) rates at equal distances, each as wide as one to m / FEWEST distances."""
    areas = np.zeros(rates.shape[1])
    for width in range(1, (len(rates) - 1) // FEWEST + 1):
        changes = rates
        for _ in range(ORDER):
            changes = changes[width:] - changes[:-width]
        areas = np.maximum(areas, width / WEIGHT * np.abs(changes).max(axis=0))
    return areas  # NaN if a rate is


def _just_before(time: float, closeness: float, shortest: float) -> float:
    """Return a step that ends just before a switch, or the shortest step, which crosses it, if it is too close."""
    step = time - max(SHORT * closeness * time, AT_HAND * shortest)
    return step if step > AT_HAND * shortest else shortest


def _signs(seen: Array) -> Array:
    """Return (q, 1) signs at the start, or at the first point where the function is not zero."""
    first = np.argmax(seen != 0.0, axis=1)
    signs: Array = np.sign(seen[np.arange(len(seen)), first])
    return signs[:, None]


def _first_zero(x: Array, positive: Array) -> float:
    """Return the first zero crossing of functions that are positive at the start; infinity if there is none.

    Return 0 if a function leaves zero at the start, since the rates at the start may belong to the other side.
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
    """Return the first zero crossing of functions that return to positive before the next point of X.

    Refine the points near each minimum until one is beyond zero or no parabola reaches zero.
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
    """Return the indices of points near which a parabola through three points has a minimum close to zero."""
    curvature = positive @ DIFFERENCES[:, :-1]
    a, b, c = positive[:, :-2], positive[:, 1:-1], positive[:, 2:]
    if (np.minimum(b, c) > 0.225 * curvature).all():
        return []
    with np.errstate(all="ignore"):
        lowest = b - (a - c) ** 2 / (8 * curvature)
    turning = (b <= a) & (b <= c)
    turning[:, -1] |= (c < b)[:, -1] & (a + 3.0 * c > 4.0 * b)[:, -1]  # rises at the end: minimum between the last two
    points = np.flatnonzero((turning & (curvature > 0) & (lowest < 0.1 * curvature)).any(axis=0))
    turns: list[int] = (points + 1).tolist()
    return turns


def _saturated(arguments: Sequence[Array]) -> float:
    """Return the fraction of a step in which no argument u of exp, tanh etc. changes by more than |u| and 2 REACH."""
    part = math.inf
    for u in arguments:
        beyond = np.abs(u - u[0]) > 2.0 * max(0.5 * abs(u[0]), REACH)
        if beyond.any():
            part = min(part, float(X[max(int(np.argmax(beyond)) - 1, 1)]))
    return part
