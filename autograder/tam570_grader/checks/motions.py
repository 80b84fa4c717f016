"""Diagnose a wrong motion from its rows: late, wrapped, from another call, interpolated, at a loose tolerance."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from tam570.meter import Exhausted, limited
from tam570.values import Function, Numbers
from tam570_grader.checks.case import Case
from tam570_grader.checks.expect import Failed, NotWritten
from tam570_grader.checks.expected import expected_result
from tam570_grader.checks.student import StudentFunction

Array = NDArray[np.float64]
# Returns the arguments behind t that begin the motion at a row, or a motion elsewhere with the same increments.
Restart = Callable[[Array], tuple[Numbers, ...]]


def flat(rows: Numbers) -> Array:
    """Return rows, or several arrays of them side by side, as an array (n, k)."""
    parts = rows if isinstance(rows, tuple) else (rows,)
    return np.hstack([np.reshape(part, (len(part), -1)) for part in parts])


ALIKE = 1e-3  # of the scale, or of an effect: two integrations of one motion differ by less
DENSE = 1e-4  # of the scale: a solver's interpolation at a loose tolerance errs by less, linear interpolation by more
BETTER = 0.1  # of the error: less remains at other times if the times are the cause
DENSER = 400  # number of times at which a motion is refined
ROUGHLY = 0.1  # of the scale: for a larger error, a small wrong term is as likely as a loose tolerance
FEWEST = 3  # rows that lead to the next, including the first
TRIED = 12  # rows from which the reference motion is integrated to the next
JUMPED = 0.9  # of the sum of the errors of all steps; a larger error is a jump
OBEYED = 0.03  # of the change between rows: the error of a wrong term is larger, that of a loose tolerance smaller
# Of the duration: so short that integration errors vanish, while a wrong term has its full effect on the rate.
INSTANTS = 1e-8, 1e-7
LONGER = 3  # durations in which the time of the student's second row is sought
MOST_STEPS = 4  # time steps of the student's that are tried
ASKED = 6  # rows, and right states, from which both motions are started for an instant
SHORTER = 1, 0.01  # of the duration, for a motion by wrong rates
ABSURD = 100  # scales: from rows with a larger error, the reference motion may take arbitrarily long
STEPS = 2_000_000  # limit for the reference motion from a student's rows
EXPLAINED, EXPLAINS = 0.03, 0.5  # of the errors: right rates cause less than the first, wrong ones more than the second


@dataclass(frozen=True)
class ComparedMotion:
    """A case, with the student's rows, the expected ones, and the scale of each column."""

    case: Case
    actual: Array
    expected: Array
    scales: Array
    function: StudentFunction
    reference: Function
    restart: Restart | None = None

    @property
    def t(self) -> Array:
        return np.asarray(self.case.args[0])

    @cached_property
    def errors(self) -> Array:
        """The errors (n, k), relative to the scales; NaN counts as infinite."""
        errors = np.abs(self.actual - self.expected) / self.scales
        return np.where(np.isnan(errors), np.inf, errors)

    @property
    def error(self) -> float:
        return float(self.errors.max())

    def near(self, rows: Numbers, quantity: Numbers = None) -> bool:
        """Return whether the student's rows, or `quantity`, agree with these rows, but not also with the expected."""
        actual, tolerance = self.actual if quantity is None else quantity, min(ALIKE, BETTER * self.error)
        return np.shape(rows) == actual.shape and bool(np.max(np.abs(rows - actual) / self.scales) <= tolerance)

    def repeated_at(self, t: Array, *start: Numbers) -> Array:
        """Return the student's rows at other times, or from another start; NaN if the call fails."""
        try:
            return flat(self.function.aside(self.case.replace(t, *start)))
        except (Failed, NotWritten):
            return np.full((len(t), len(self.scales)), np.nan)

    def truly(self, t: Array, *start: Numbers) -> Array:
        """Return the reference's rows at other times, or from another start."""
        case = self.case.replace(t, *start)
        return flat(expected_result(self.reference, case))


def diagnosed(
    motion: ComparedMotion,
    motions: Sequence[ComparedMotion],
    turns: Sequence[int],
    near_miss: float,
    rates_are_right: Callable[[], bool] | None = None,
) -> str:
    """Return a sentence that says what a wrong motion is; empty if the rows do not show it.

    near_miss : the error, relative to the scale, up to which a loose tolerance is likely even if nothing moves
    rates_are_right : returns whether the student's own function of the rates is right
    """
    with np.errstate(all="ignore"):
        moves = np.max(np.ptp(motion.expected, axis=0) / motion.scales) > ALIKE  # rest is the same at any times
        message = next((sentence for is_so, sentence in _rules(motion, motions, turns) if moves and is_so()), "")
        if message or not (motion.error <= near_miss or obeys(motion)):
            return message
        share = _explained(motion)
        if share >= EXPLAINS or _jumps(motion):
            return ""
        likely = share <= EXPLAINED and (motion.error <= ROUGHLY or bool(rates_are_right and rates_are_right()))
        return TIGHT if likely else NEARLY_FOLLOWS


TIGHT = "The physics is right: tighten rtol and atol, or take smaller steps"
NEARLY_FOLLOWS = "Each row nearly follows from the row before: is a term wrong, or are rtol and atol loose?"
Rule = tuple[Callable[[], bool], str]


def _rules(motion: ComparedMotion, motions: Sequence[ComparedMotion], turns: Sequence[int]) -> list[Rule]:
    """Return pairs (test, sentence) in the order of the tests: cheap and certain ones first."""
    inner, expected = motion.actual[1:-1], motion.expected
    return [
        (lambda: _repeats(motion, 0), "Every row is the start"),
        (lambda: not motion.actual.any(), "Every number is zero"),
        (lambda: _repeats(motion, -1), ALL_THE_LAST),
        (lambda: len(inner) > 0 and motion.near(expected[2:], inner), ONE_ROW_AHEAD),
        (lambda: len(inner) > 0 and motion.near(expected[:-2], inner), BEHIND),
        (lambda: motion.near(expected, np.copysign(motion.actual, expected)), SIGNS),
        (lambda: motion.errors[0].max() > ALIKE >= motion.errors[1:].max(), OTHER_START),
        (lambda: _turned(motion, turns), WRAPPED),
        (lambda: _even(motion), EVEN),
        (lambda: _from_zero(motion), FROM_ZERO),
        (lambda: _reordered(motion), "The columns are in another order"),
        (lambda: _another(motion, motions), KEPT),
        (lambda: _joined(motion), JOINED),
        (lambda: _denser(motion), SAMPLED),
        (lambda: _at_other_times(motion), OTHER_TIMES),
        (lambda: _from_elsewhere(motion), FROM_ELSEWHERE),
    ]


ONE_ROW_AHEAD = "Row i is the state at t[i+1], not at t[i]"
BEHIND = "Row i is the state at t[i-1], not at t[i]"
SIGNS = "Only signs are wrong: does a square root lose one, or does a force or a turn have the wrong sense?"
OTHER_START, WRAPPED = "Row 0 is not the start", "Only whole turns are missing: never wrap angles"
EVEN = "These are the rows at evenly spaced times: use the times in t"
FROM_ZERO = "The start is taken at t = 0: it is the state at t[0]"
KEPT = "This is the motion of an earlier call: is a result kept between calls?"
OTHER_TIMES = "These are rows of the right motion at other times: use the times in t"
ALL_THE_LAST = "Every row is the last one: do you append one array, which you change?"
# rows of the right motion, with a mistake that may recur in later checks
OF_TIMES = ONE_ROW_AHEAD, BEHIND, OTHER_START, WRAPPED, EVEN, FROM_ZERO, KEPT, OTHER_TIMES, ALL_THE_LAST
FROM_ELSEWHERE = "The rows follow from one another, but not from the start: with which state do you begin?"
OF_ROWS = *OF_TIMES, SIGNS, FROM_ELSEWHERE
JOINED = (
    "This row is accurate when requested alone: do you interpolate linearly between steps, or at a loose tolerance?"
)
SAMPLED = "With more times in between the same rows are accurate: take smaller steps"
OF_STEPS = TIGHT, JOINED, SAMPLED  # the physics is right


def _repeats(motion: ComparedMotion, row: int) -> bool:
    """Return whether every row is this row of the right motion."""
    return bool((motion.actual == motion.actual[row]).all()) and bool(motion.errors[row].max() <= ALIKE)


def _turned(motion: ComparedMotion, turns: Sequence[int]) -> bool:
    off = np.zeros_like(motion.actual)
    columns = list(turns)
    off[:, columns] = 2 * np.pi * np.round((motion.actual - motion.expected)[:, columns] / (2 * np.pi))
    return bool(off.any()) and motion.near(motion.expected, quantity=motion.actual - off)


def _even(motion: ComparedMotion) -> bool:
    t = motion.t
    return any(
        motion.near(motion.truly(even))
        for even in (np.linspace(t[0], t[-1], len(t)), t[0] + (t[1] - t[0]) * np.arange(len(t)))
        if len(t) > 2
    )


def _at_other_times(motion: ComparedMotion) -> bool:
    """Return whether the rows are right at evenly spaced times with another step, such as the student's own."""
    moved = np.max(np.ptp(motion.actual, axis=0) / motion.scales)
    if len(motion.t) < 3 or not ROUGHLY < moved <= ABSURD or motion.errors[0].max() > ALIKE:
        return False
    start, count = motion.t[0], np.arange(len(motion.t))
    try:
        with limited(STEPS):
            return any(motion.near(motion.truly(start + step * count)) for step in _steps(motion))
    except (ValueError, ArithmeticError, Exhausted):
        return False


def _steps(motion: ComparedMotion) -> Iterator[float]:
    """Yield the durations after which the right motion passes through the student's second row."""
    start, later = motion.t[0], LONGER * (motion.t[-1] - motion.t[0]) * np.linspace(0, 1, LONGER * DENSER + 1)

    def missed(durations: Array) -> Array:
        return np.asarray(np.abs(motion.truly(start + durations) - motion.actual[1]) / motion.scales)

    off = missed(later).max(axis=1)
    closest = (off[1:-1] <= off[:-2]) & (off[1:-1] <= off[2:]) & (off[1:-1] < ROUGHLY)
    for index in np.flatnonzero(closest)[:MOST_STEPS]:
        fine = np.append(0.0, np.linspace(later[index], later[index + 2], DENSER + 1)[1:])
        rows = missed(fine)
        squares = np.sum(rows**2, axis=1)
        if 1 < (least := int(np.argmin(squares))) < DENSER and rows[least].max() <= 2 * ALIKE:
            before, at, after = squares[least - 1 : least + 2]
            yield float(fine[least] + (fine[-1] - fine[-2]) * (before - after) / (before - 2 * at + after) / 2)


def _from_elsewhere(motion: ComparedMotion) -> bool:
    """Return whether the motion is wrong, but each row after the first leads to the next by the right equations."""
    rows = _some(motion)
    moved = np.abs(motion.actual[rows + 1] - motion.actual[rows]) / motion.scales
    if len(rows) < FEWEST or not ROUGHLY < motion.error <= ABSURD or moved[1:].max() <= ROUGHLY:
        return False
    lost = _lost(motion, rows)
    return bool(lost[1:].max() <= ALIKE) and max(lost[0], motion.errors[0].max()) > ROUGHLY


def _from_zero(motion: ComparedMotion) -> bool:
    """Return whether the rows after t = 0 are the right motion with its start at t = 0 instead of t[0]."""
    t = motion.t
    after = t > max(t[0], 0.0)
    if t[0] == 0 or not after.any():
        return False
    try:
        return motion.near(motion.truly(np.append(0.0, t[after]))[1:], quantity=motion.actual[after])
    except (ValueError, ArithmeticError):
        return False


def _reordered(motion: ComparedMotion) -> bool:
    columns = motion.actual.T[:, :, None] - motion.expected[None]  # all differences of two columns
    off = np.fmin(np.abs(columns / motion.scales).max(axis=1), 1.0)  # a NaN counts as 1
    if off.min(axis=1).max() > ALIKE:
        return False
    from scipy.optimize import linear_sum_assignment

    return motion.near(motion.expected[:, linear_sum_assignment(off)[1]])


def _another(motion: ComparedMotion, motions: Sequence[ComparedMotion]) -> bool:
    others = [other for other in motions if other is not motion and other.expected.shape == motion.expected.shape]
    return any(
        motion.near(other.expected) and not motion.near(other.expected, quantity=motion.expected) for other in others
    )


def _joined(motion: ComparedMotion) -> bool:
    """Return whether the worst row is right if its time is the last, where every integrator ends a step."""
    row = int(np.argmax(motion.errors.max(axis=1)))
    gathers = motion.errors[-1].max() > motion.error / 2  # the error accumulates, as that of interpolation does not
    if row == 0 or gathers or len(motion.t) < 3 or not DENSE < motion.error < 1:
        return False
    repeated = motion.repeated_at(motion.t[[0, row]])
    return bool(np.max(np.abs(repeated[-1] - motion.expected[row]) / motion.scales) <= BETTER * motion.error)


def _denser(motion: ComparedMotion) -> bool:
    """Return whether the rows become right with more times in between, which excludes a wrong equation."""
    t, between = motion.t, max(2, DENSER // len(motion.t))
    repeated = motion.repeated_at(_finer(t, between))
    return bool(np.max(np.abs(repeated[::between] - motion.expected) / motion.scales) <= BETTER * motion.error)


def _finer(t: Array, count: int) -> Array:
    """Return the times with each step divided into `count` steps."""
    return np.append(np.linspace(t[:-1], t[1:], count, endpoint=False).T.ravel(), t[-1])


def obeys(motion: ComparedMotion, *, everywhere: bool = False) -> bool:
    """Return whether each row nearly follows from the previous one by the right equations.

    everywhere : test every row, without exception; else some rows, of which a tenth may fail
    """
    if not motion.error <= ABSURD or motion.errors[0].max() > ALIKE:
        return False
    rows = np.arange(len(motion.t) - 1) if everywhere else _some(motion)
    off = _lost(motion, rows)
    moved = np.abs(motion.actual[rows + 1] - motion.actual[rows]) / motion.scales
    return bool(np.quantile(off, 1.0 if everywhere else 0.9) <= OBEYED * np.median(moved.max(axis=1)))


def _some(motion: ComparedMotion, count: int = TRIED) -> NDArray[np.int_]:
    """Return the indices of up to `count` evenly spread rows, without the last row."""
    return np.unique(np.linspace(0, len(motion.t) - 2, count).astype(int))


def _lost(motion: ComparedMotion, rows: NDArray[np.int_]) -> Array:
    """Return the error of each step from these rows to the next, relative to the scale; NaN if the reference fails."""
    led = (motion.truly(motion.t[row : row + 2], *_restart(motion, motion.actual[row])) for row in rows)
    try:
        with limited(STEPS):
            steps = np.vstack([np.diff(states, axis=0) for states in led])
    except (ValueError, ArithmeticError, Exhausted):
        return np.full(len(rows), np.nan)
    off = steps - (motion.actual[rows + 1] - motion.actual[rows])
    return np.asarray(np.max(np.abs(off) / motion.scales, axis=1))


def _jumps(motion: ComparedMotion) -> bool:
    """Return whether nearly all of the error arises between two of many rows, unlike with a loose tolerance."""
    lost = _lost(motion, np.arange(len(motion.t) - 1))
    return lost.size >= TRIED and float(lost.max()) > max(ROUGHLY, JUMPED * float(lost.sum()))


def has_coarse_steps(motion: ComparedMotion) -> bool:
    """Return whether a motion that is far off makes errors in many steps, and leaves its states at the right rates."""
    t = _finer(motion.t, 1 + 2 * TRIED // len(motion.t))
    fine = replace(motion, case=motion.case.replace(t), actual=motion.repeated_at(t), expected=motion.truly(t))
    with np.errstate(all="ignore"):
        if not fine.error <= ABSURD or fine.errors[0].max() > ALIKE:
            return False
        lost = _lost(fine, np.arange(len(t) - 1))
        return float(lost.max()) <= JUMPED * float(lost.sum()) and _explained(fine) <= EXPLAINED


def _explained(motion: ComparedMotion) -> float:
    """Return the share of the errors that wrong rates cause: near zero if the physics is right, NaN if undecided."""
    rows, shares = _some(motion), list[float]()
    try:
        lost = _lost(motion, rows) / np.diff(motion.t)[rows]
        starts = list(_worst(motion, rows[np.argsort(-lost)]))
        for instant in INSTANTS:
            shares.append(_apart(motion, starts, instant) / lost.max())
            if shares[-1] <= EXPLAINED:
                return shares[-1]
    except (Failed, NotWritten, ValueError, ArithmeticError, Exhausted):
        return np.nan
    return min(shares) if max(shares) <= 2 * min(shares) else np.nan  # rounding, or an integrator's first step


def _worst(motion: ComparedMotion, rows: NDArray[np.int_]) -> Iterator[tuple[float, Array]]:
    """Yield times and states where most of the error arises: the worst rows first, then right states after the first.

    If a row violates a constraint, use the state to which the reference motion projects it.
    """
    for row in rows[:ASKED]:
        yield motion.t[row], motion.truly(motion.t[row : row + 2], *_restart(motion, motion.actual[row]))[0]
    times = np.linspace(motion.t[rows[0]], motion.t[rows[0] + 1], ASKED + 1)
    yield from zip(times[1:], motion.truly(times, *_restart(motion, motion.actual[rows[0]]))[1:], strict=True)


def _apart(motion: ComparedMotion, starts: Sequence[tuple[float, Array]], instant: float) -> float:
    """Return the largest rate, in scales per s, at which the student's function departs from the reference."""
    rates = list[float]()
    for at, state in starts:
        t, start = at + _instant(motion, instant), _restart(motion, state)
        result = flat(motion.function.aside(motion.case.replace(t, *start)))
        off = np.diff((result - motion.truly(t, *start)) / motion.scales, axis=0)
        rates.append(float(np.max(np.abs(off)) / np.ptp(t)))
    return max(rates)


@dataclass(frozen=True)
class Rates:
    """The student's own rates, from which a motion may follow.

    at : (t, row) -> rates of the first or the last columns; the other columns have the right rates
    move : returns whether the motion changes if these rates do
    back : the student's function that projects a state onto a constraint
    truth : the right rates, of the same columns
    doubled : (index, case) -> the motion if one of the student's rates is doubled; None if there is none
    """

    at: Callable[[float, Array], Numbers]
    move: Callable[[], bool]
    back: Callable[[Array], Numbers] | None = None
    truth: Callable[[float, Array], Numbers] | None = None
    doubled: Callable[[int, Case], Numbers] | None = None

    def models(self, t: float, row: Array, rate: Array, instant: float) -> Array:
        """Return the rates (3, k) at which a motion by the student's rates may leave a row; `rate` is right."""
        rates, models = np.ravel(self.at(t, row)), np.array([rate] * 3)
        models[0, : rates.size] = models[1, -rates.size :] = rates
        if self.back:
            models[2] = (np.ravel(self.back(row + models[1] * instant)) - row) / instant
        return models


def has_rates(motion: ComparedMotion, rates: Rates, *, ends: bool = True) -> bool:
    """Return whether the motion follows from the student's wrong rates, with nothing else wrong in it.

    Projections onto a constraint may undo all that is wrong with the rates at each instant, and leave their effect
    within the steps.

    ends : whether the student's rows can be compared; if the motion breaks off, only its first instants can
    """
    rows = _some(motion, ASKED)
    unexplained, wrong, undone = np.zeros(3), np.zeros(3), 0.0
    try:
        for row in rows:
            t, instant_rate, expected_rate = _set_off(motion, row)
            models = rates.models(t[0], motion.expected[row], expected_rate, np.ptp(t))
            off = np.abs(np.array([instant_rate - models, models - expected_rate])) / motion.scales
            unexplained, wrong = np.maximum([unexplained, wrong], off.max(axis=2))
            undone = max(undone, float(np.max(np.abs(instant_rate - expected_rate) / motion.scales)))
        explained = np.any((unexplained <= EXPLAINED * wrong) & (wrong > 0))
        if (explained or _would_set_off(motion, rates)) and (not ends or _leads_on(motion)):
            return True
        # rows projected onto a constraint may differ from the states from which the motion continues
        is_undone = undone <= EXPLAINED * wrong[:2].min()
        return bool(is_undone or (explained and rates.back)) and rates.move()
    except (Failed, NotWritten, ValueError, ArithmeticError, Exhausted):
        return False


def sets_off(motion: ComparedMotion) -> bool:
    """Return whether the student's motion leaves right states at the right rates."""
    try:
        for row in _some(motion, ASKED):
            _, rate, expected = _set_off(motion, row)
            off, most = (np.max(np.abs(each) / motion.scales) for each in (rate - expected, expected))
            if not off <= EXPLAINED * most:
                return False
    except (Failed, NotWritten, ValueError, ArithmeticError, Exhausted):
        return False
    return True


def _would_set_off(motion: ComparedMotion, rates: Rates) -> bool:
    """Return whether the motion would leave right states at the right rates if the student's rates were right.

    For an instant its effect is linear in each of them, also if the rows are projected onto a constraint.
    """
    if not rates.truth or not rates.doubled:
        return False
    off = list[Array]()
    for row in _some(motion, ASKED):
        t, rate, expected = _set_off(motion, row)
        student, true = (np.ravel(each(t[0], motion.expected[row])) for each in (rates.at, rates.truth))
        case, would_be = motion.case.replace(t, *_restart(motion, motion.expected[row])), rate.copy()
        for index in np.flatnonzero(~np.isclose(student, true)):
            rows = rates.doubled(int(index), case) if student[index] else None
            if rows is None:
                return False
            would_be += (true[index] / student[index] - 1) * (np.diff(flat(rows), axis=0)[0] / np.ptp(t) - rate)
        off.append(np.max(np.abs([would_be, rate] - expected) / motion.scales, axis=1))
    unexplained, wrong = np.max(off, axis=0)
    return bool(unexplained < ALIKE * wrong)


def _leads_on(motion: ComparedMotion) -> bool:
    """Return whether the student's motion, started at some of its rows, makes the same steps as before.

    Wrong rates may lead to a singularity, beyond which no two motions agree: then use a shorter motion.
    """
    for share in SHORTER:
        t = motion.t[0] + share * (motion.t - motion.t[0])
        own_rows = motion.actual if share == 1 else motion.repeated_at(t)
        if not np.max(np.abs(own_rows - own_rows[0]) / motion.scales) <= ABSURD:
            continue
        off = list[Array]()
        for row in _some(motion, ASKED):
            led = motion.repeated_at(t[row : row + 2], *_restart(motion, own_rows[row]))
            off.append(np.diff(led, axis=0)[0] - (own_rows[row + 1] - own_rows[row]))
        return bool(np.max(np.abs(off) / motion.scales) <= ALIKE * share)
    return False


def _set_off(motion: ComparedMotion, row: int) -> tuple[Array, Array, Array]:
    """Return the times of an instant after a right row, and the rates of the student's motion and of the reference."""
    t, start = motion.t[row] + _instant(motion, INSTANTS[-1]), _restart(motion, motion.expected[row])
    own_rows, right_rows = flat(motion.function.aside(motion.case.replace(t, *start))), motion.truly(t, *start)
    return t, np.diff(own_rows, axis=0)[0] / np.ptp(t), np.diff(right_rows, axis=0)[0] / np.ptp(t)


def _instant(motion: ComparedMotion, share: float) -> Array:
    return np.array([0, share * (motion.t[-1] - motion.t[0])])


def _restart(motion: ComparedMotion, row: Array) -> tuple[Numbers, ...]:
    """Return the arguments behind t that begin the motion at a row; raise ValueError if the row does not have them."""
    if motion.restart:
        return motion.restart(row)
    starts = [value for value in motion.case.args[1:] if not isinstance(value, str)]
    ends = np.cumsum([np.size(value) for value in starts])
    if not starts or ends[-1] != len(row):
        raise ValueError("the row is not a start")
    pairs = zip(np.split(row, ends[:-1]), starts, strict=True)
    return tuple(part.reshape(np.shape(value)) if np.ndim(value) else float(part[0]) for part, value in pairs)
