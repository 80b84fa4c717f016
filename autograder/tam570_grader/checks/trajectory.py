"""A simulated motion against the right one: what is compared, and what a wrong one is called."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import product

import numpy as np
from numpy.typing import NDArray

from tam570.values import Json, Numbers
from tam570_grader.checks.case import Case
from tam570_grader.checks.compare import (
    Batch,
    Column,
    Reference,
    find_reference,
    is_right,
    own_result,
    trim_to_signature,
)
from tam570_grader.checks.curves import Curve, curve
from tam570_grader.checks.expect import NEAR_MISS, NEAR_MISS_SHARE, Failed, FollowsFrom, NotWritten, expect, get_context
from tam570_grader.checks.formulas import in_symbols
from tam570_grader.checks.motions import (
    OF_STEPS,
    ROUGHLY,
    ComparedMotion,
    Rates,
    Restart,
    diagnosed,
    flat,
    has_rates,
    obeys,
    sets_off,
)
from tam570_grader.checks.returns import Formula
from tam570_grader.checks.student import StudentFunction

Array = NDArray[np.float64]
# Right physics at a loose tolerance keeps these shares of the points at these errors (of the scale), and in proportion
# to the logarithm of the error between them and ten limits, so that no grade leaps with the seed.
ASKED = 4  # rows of a motion, at which the rates are asked
SETTING_OFF = 1e-3  # of the first step of a motion that breaks off
TIGHTEN = "Use a tighter tolerance, or a smaller step"
LOOSE_SHARES = {1e-3: 0.5, ROUGHLY: 0.25}


@dataclass(frozen=True)
class Invariant:
    """What every right motion keeps: value(rows, **parameters) -> (n, ...), and the scale of its drift."""

    quantity: str  # "the energy"
    unit: str
    value: Callable[..., Array]
    scale: Callable[[Case, Array], float] | None  # scale(case, right rows); None: its value at the start, in size
    tolerance: float

    def size(self, case: Case, rows: Array) -> float:
        """Return what its drift is relative to; 1 where that is zero."""
        start = self.scale(case, rows) if self.scale else np.linalg.norm(self.value(rows[:1], **case.kwargs))
        return float(start) or 1.0


@dataclass(frozen=True)
class OwnRates:
    """The student's function of the rates in a simulated motion, which may be right where the motion is wrong.

    name : of the function, or of its formula, in the symbols of these arguments and of the parameters, in order
    arguments : (t, row) -> what the rates are asked for there, by default both; words of the motion's case follow
    otherwise : others, from which the motion may follow as well
    passes : the student's function of a state that each row may go through
    """

    name: str
    reference: Reference
    arguments: Callable[[float, Array], tuple[Numbers, ...]] = lambda t, row: (t, row)
    otherwise: "OwnRates | None" = None
    passes: str = ""

    def are_right(self, motion: ComparedMotion) -> bool:
        """Return whether they are right at some rows of the right motion."""
        rows = list(zip(motion.t, motion.expected, strict=True))[:: max(1, len(motion.t) // ASKED)]
        return is_right(self._function(motion), self.reference, [self._case(motion, t, row) for t, row in rows])

    def source(self, motion: ComparedMotion, *, ends: bool = True) -> str:
        """Return the student's wrong function from which the motion follows; else nothing.

        ends : False of a motion without rows
        """
        student_rates, back = self._function(motion), partial(self._back, motion) if self.passes else None
        t = motion.t[:2] if ends else motion.t[0] + SETTING_OFF * np.array([0, motion.t[1] - motion.t[0]])
        uses_them = partial(motion.function.uses, student_rates.name, motion.case.replace(t))
        rates = Rates(lambda t, row: student_rates.aside(self._case(motion, t, row)), uses_them, back)
        if not self.are_right(motion) and has_rates(motion, rates, ends=ends):
            return FollowsFrom(self.name)
        if back and ends:
            try:
                near = motion.near(np.array([back(row) for row in motion.expected]))
                if (near or self._is_led_astray(motion)) and motion.function.uses(self.passes, motion.case):
                    return FollowsFrom(self.passes)
            except (Failed, NotWritten):
                pass
        return self.otherwise.source(motion, ends=ends) if self.otherwise else ""

    def _is_led_astray(self, motion: ComparedMotion) -> bool:
        """Return whether the rates are right, and what each row may go through is wrong beside the right motion."""
        function = getattr(motion.function.student, self.passes)
        beside = [Case(row + row[::-1] / 10, **motion.case.kwargs) for row in motion.expected[:ASKED]]
        return self.are_right(motion) and sets_off(motion) and not is_right(function, self.reference, beside)

    def _back(self, motion: ComparedMotion, row: Array) -> Numbers:
        function: StudentFunction = getattr(motion.function.student, self.passes)
        return own_result(function, self.reference, Case(row, **motion.case.kwargs))

    def hint(self, motion: ComparedMotion) -> str:
        """Say where to look."""
        if self.are_right(motion):
            return f"{self.name} is right along this motion: integrate it, with the given parameters, from t[0] on"
        return self.source(motion) or f"{self.name} is wrong along this motion, too: look there first"

    def _function(self, motion: ComparedMotion) -> StudentFunction:
        function: StudentFunction = getattr(motion.function.student, self.name)
        return function

    def _case(self, motion: ComparedMotion, t: float, row: Array) -> Case:
        words = [word for word in motion.case.args if isinstance(word, str)]
        case, function = Case(*self.arguments(t, row), *words, **motion.case.kwargs), self._function(motion)
        if isinstance(function.returns, Formula):
            return in_symbols([case], *function.returns.symbols)[0]
        return trim_to_signature(find_reference(self.reference, function), [case])[0]


def compare_trajectory(  # noqa: PLR0913  as `compare`
    function: StudentFunction,
    reference: Reference,
    cases: Iterable[Case],
    columns: Sequence[Column] = (),
    *,
    tolerance: float,
    hint: str | Callable[[ComparedMotion], str] = "",
    keeps: Invariant | None = None,
    restart: Restart | None = None,
    near_miss_credit: bool = True,
    loose_tolerance_credit: bool = True,
    chaotic: bool = False,
) -> list[ComparedMotion]:
    """Fail unless the student's simulation follows the right motion in every case; the motions, for further checks.

    reference : reference(t, *start, **parameters) -> rows, or several arrays of them; or the module, as for `compare`
    columns : left out, as `Assignment.returns` has them
    tolerance : of the scale of each column
    hint    : where to look, or a function of the motion that says it, if the rows themselves tell nothing
    keeps   : an invariant whose course the student's page draws beside the error
    restart : restart(row) -> the arguments behind t that begin the motion there; default: the row, cut as these are
    near_miss_credit : False where an error of a few limits is no sign that the physics is right
    loose_tolerance_credit : False where wrong physics nearly obeys the equations: a tenth of an error is no sign
    chaotic : a motion in which each row leads to the next has followed, too, however far its errors have grown
    """
    columns = columns or function.returns.columns
    # no share is left, whatever the other motions are
    hopeless = np.inf if chaotic else max(ROUGHLY, NEAR_MISS * tolerance)
    motions = _motions(function, reference, cases, columns, restart, hopeless)
    if not get_context().listens and max(motion.error for motion in motions) <= tolerance:
        return motions
    width = motions[0].expected.shape[1]
    turns = [index for column in columns if column.turns for index in np.arange(width)[column.where]]
    # the worst first; of those beyond hope the longest, of which there is most to draw
    order, near_miss = partial(_telling, tolerance), NEAR_MISS * tolerance if near_miss_credit else 0.0
    for motion in sorted(motions, key=order, reverse=True):
        if chaotic and motion.error > tolerance and obeys(motion, everywhere=True):
            continue
        get_context().set_call(function.name, motion.case)
        if not chaotic:
            _note(motion, columns, tolerance)
        # the column that is off most, in its own unit
        column = max(columns, key=lambda column: np.max(motion.errors[:, column.where], initial=0.0))
        size = float(np.max(motion.scales[column.where]))
        has_shares = near_miss_credit and loose_tolerance_credit
        expect(
            motion.actual[:, column.where],
            motion.expected[:, column.where],
            tolerance=tolerance * size,
            quantity=column.quantity,
            unit=column.unit,
            t=motion.case.args[0],
            partial=partial(loose_tolerance_share, motion, tolerance, size) if has_shares else None,
            near_miss_credit=near_miss_credit,
            hint=partial(_hint, motion, motions, turns, near_miss, hint),
            keeps=partial(_along, keeps, motion) if keeps else None,
        )
    return motions


def check_conserved(
    function: StudentFunction,
    reference: Reference,
    cases: Iterable[Case],
    *invariants: Invariant,
    coarsely: float,
    partial: dict[float, float] | None = None,
    hint: str = TIGHTEN,
) -> None:
    """Fail unless invariants keep their values at the start along motions that are followed coarsely.

    coarsely : of the scale of each column; where errors grow fast, it is enough that each row leads to the next
    """
    motions = compare_trajectory(
        function, reference, cases, tolerance=coarsely, hint=hint, near_miss_credit=False, chaotic=True
    )
    compare_invariants(function, motions, *invariants, partial=partial, hint=hint)


def compare_invariants(
    function: StudentFunction,
    motions: Iterable[ComparedMotion],
    *invariants: Invariant,
    partial: dict[float, float] | None = None,
    hint: str = TIGHTEN,
) -> None:
    """Fail unless invariants keep their values at the start along a student's motions."""
    for invariant, motion in product(invariants, motions):
        case = motion.case
        start = invariant.value(motion.expected[:1], **case.kwargs)
        get_context().set_call(function.name, case)
        expect(
            invariant.value(motion.actual, **case.kwargs),
            np.broadcast_to(start, (len(motion.actual), *np.shape(start)[1:])),
            tolerance=invariant.tolerance,
            scale=invariant.size(case, motion.expected),
            quantity=invariant.quantity,
            unit=invariant.unit,
            t=case.args[0],
            partial=partial,
            hint=hint,
        )


def _motions(
    function: StudentFunction,
    reference: Reference,
    cases: Iterable[Case],
    columns: Sequence[Column],
    restart: Restart | None,
    hopeless: float,
) -> list[ComparedMotion]:
    """Return the student's motions, the longest first; where its error is hopeless, the others are not asked for."""
    motions, true = list[ComparedMotion](), find_reference(reference, function)
    first, *rest = sorted(cases, key=lambda case: -len(case.args[0]))
    for some in filter(None, ([first], rest)):
        batch = Batch.of(true, some)
        scaled_rows = partial(batch.remembered, ("rows", *map(id, columns)), partial(_scaled_rows, batch, columns))
        try:
            compared = batch.compared(function, batch.results(function))
        except Failed as failed:
            case, rates = failed.failure.at, function.returns.rates
            # arrays have no one truth; of a function that was given up the case is another
            number = next((index for index, other in enumerate(batch.cases) if other is case), 0)
            if rates:
                expected, scales = scaled_rows()[1][number]
                motion = ComparedMotion(batch.cases[number], expected, expected, scales, function, true, restart)
                with get_context().aside():
                    failed.failure = replace(failed.failure, follows_from=str(rates.source(motion, ends=False)))
            raise
        _, scaled = scaled_rows()
        for (case, result, _), (expected, scales) in zip(compared, scaled, strict=True):
            motions.append(ComparedMotion(case, flat(result), expected, scales, function, true, restart))
        if motions[0].error > hopeless and not get_context().recorder:
            break
    return motions


def _scaled_rows(batch: Batch, columns: Sequence[Column]) -> tuple[Sequence[Column], list[tuple[Array, Array]]]:
    """Return the right rows of each case and their scales; with the columns, by which they are remembered."""
    scaled_rows = []
    for case, expected in zip(batch.cases, map(flat, batch.expected), strict=True):
        scales = np.ones(expected.shape[1])  # where all is zero
        for column in columns:
            scales[column.where] = column.size(case, expected)
        scaled_rows.append((expected, scales))
    return columns, scaled_rows


def _note(motion: ComparedMotion, columns: Sequence[Column], tolerance: float) -> None:
    """Note what each column is compared with, for the examples that students have."""
    for column in columns:
        where = np.arange(motion.expected.shape[1])[column.where].tolist()
        scale = float(np.max(motion.scales[where]))
        limits = {"quantity": column.quantity, "scale": scale, "tolerance": tolerance}
        get_context().add_example(motion.function, motion.case, None, where, motion.expected[:, where], **limits)


def _telling(tolerance: float, motion: ComparedMotion) -> tuple[bool, int, float]:
    hopeless = motion.error > NEAR_MISS * tolerance
    return hopeless, len(motion.actual) if hopeless else 0, motion.error


def loose_tolerance_share(motion: ComparedMotion, tolerance: float, size: float, error: float) -> float:
    """Right physics at a loose tolerance keeps a share that falls with the error; a NaN keeps nothing."""
    if not (error <= ROUGHLY * size and obeys(motion)):
        return 0.0
    shares = {NEAR_MISS * tolerance: NEAR_MISS_SHARE} | {
        limit: share for limit, share in LOOSE_SHARES.items() if limit > NEAR_MISS * tolerance
    }
    return round(float(np.interp(np.log(error / size), np.log(list(shares)), list(shares.values()))), 2)


def _hint(
    motion: ComparedMotion,
    motions: Sequence[ComparedMotion],
    turns: Sequence[int],
    near_miss: float,
    hint: str | Callable[[ComparedMotion], str],
) -> str:
    own_rates: OwnRates | None = motion.function.returns.rates
    rates_are_right = partial(own_rates.are_right, motion) if own_rates else None
    said = diagnosed(motion, motions, turns, near_miss, rates_are_right)
    if own_rates and said in ("", *OF_STEPS):
        said = own_rates.source(motion) or said
    said = said or (hint(motion) if callable(hint) else "")
    if not said and own_rates and not (isinstance(hint, str) and hint and own_rates.are_right(motion)):
        return own_rates.hint(motion)
    return said or ("" if callable(hint) else hint)


def _along(invariant: Invariant, motion: ComparedMotion) -> Curve | None:
    """Return what becomes of a number that the right motion keeps, along the student's, from its first value on."""
    values = invariant.value(motion.actual, **motion.case.kwargs) / invariant.size(motion.case, motion.expected)
    words: Json = {"tolerance": invariant.tolerance, "quantity": invariant.quantity, "unit": invariant.unit}
    return curve(motion.case.args[0], values, np.broadcast_to(values[:1], values.shape), 1.0, **words)
