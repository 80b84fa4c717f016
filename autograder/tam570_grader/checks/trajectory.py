"""Compare a simulated motion with the reference, and diagnose a wrong one."""

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
from tam570_grader.checks.expected import expected_result
from tam570_grader.checks.formulas import in_symbols
from tam570_grader.checks.motions import (
    ROUGHLY,
    TIGHT,
    ComparedMotion,
    Rates,
    Restart,
    diagnosed,
    flat,
    has_coarse_steps,
    has_rates,
    obeys,
    sets_off,
)
from tam570_grader.checks.returns import Formula
from tam570_grader.checks.student import StudentFunction

Array = NDArray[np.float64]
ASKED = 4  # rows of a motion at which the rates are evaluated
SETTING_OFF = 1e-3  # of the first time step, for a motion that breaks off
TIGHTEN = "Use a tighter tolerance, or a smaller step"
# Shares of the points for right physics at a loose tolerance, by its error (of the scale). From NEAR_MISS tolerances on
# they are interpolated in the logarithm of the error, so that no grade jumps with the seed.
LOOSE_SHARES = {1e-3: 0.5, ROUGHLY: 0.25}


@dataclass(frozen=True)
class Invariant:
    """A quantity that right motions conserve: value(rows, **parameters) -> (n, ...), and the scale of its drift."""

    quantity: str  # "the energy"
    unit: str
    value: Callable[..., Array]
    scale: Callable[[Case, Array], float] | None  # scale(case, expected rows); None: norm of the value at the start
    tolerance: float

    def size(self, case: Case, rows: Array) -> float:
        """Return the scale of its drift; 1 if that is zero."""
        start = self.scale(case, rows) if self.scale else np.linalg.norm(self.value(rows[:1], **case.kwargs))
        return float(start) or 1.0


@dataclass(frozen=True)
class OwnRates:
    """The student's function of the rates in a simulated motion; it may be right although the motion is wrong.

    name : of the function, or of a formula, whose symbols are these arguments and the parameters, in order
    arguments : (t, row) -> arguments of the rates there, by default both; texts among the case's arguments follow
    otherwise : other rates, from which the motion may follow as well
    passes : the student's function of a state through which each row may have passed, such as a projection
    """

    name: str
    reference: Reference
    arguments: Callable[[float, Array], tuple[Numbers, ...]] = lambda t, row: (t, row)
    otherwise: "OwnRates | None" = None
    passes: str = ""

    def are_right(self, motion: ComparedMotion) -> bool:
        """Return whether the rates are right at some rows of the right motion."""
        rows = list(zip(motion.t, motion.expected, strict=True))[:: max(1, len(motion.t) // ASKED)]
        return is_right(self._function(motion), self.reference, [self._case(motion, t, row) for t, row in rows])

    def source(self, motion: ComparedMotion, *, ends: bool = True) -> str:
        """Return FollowsFrom the student's wrong function from which the motion follows; else an empty text.

        ends : False for a motion without rows
        """
        student_rates, back = self._function(motion), partial(self._back, motion) if self.passes else None
        t = motion.t[:2] if ends else motion.t[0] + SETTING_OFF * np.array([0, motion.t[1] - motion.t[0]])
        uses_them = partial(motion.function.uses, student_rates.name, motion.case.replace(t))
        true, is_formula = find_reference(self.reference, student_rates), isinstance(student_rates.returns, Formula)
        rates = Rates(
            lambda t, row: student_rates.aside(self._case(motion, t, row)),
            uses_them,
            back,
            None if is_formula else lambda t, row: expected_result(true, self._case(motion, t, row)),
            lambda index, case: motion.function.scaled(student_rates.name, index, 2.0, case),
        )
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
        """Return whether the rates are right, but `passes` is wrong for states beside the right motion."""
        function = getattr(motion.function.student, self.passes)
        beside = [Case(row + row[::-1] / 10, **motion.case.kwargs) for row in motion.expected[:ASKED]]
        return self.are_right(motion) and sets_off(motion) and not is_right(function, self.reference, beside)

    def _back(self, motion: ComparedMotion, row: Array) -> Numbers:
        function: StudentFunction = getattr(motion.function.student, self.passes)
        return own_result(function, self.reference, Case(row, **motion.case.kwargs))

    def hint(self, motion: ComparedMotion, question: str = "") -> str:
        """Return where to look: what the check asks, unless the motion shows more."""
        if self.are_right(motion):
            integrated = f"does {motion.function.name} integrate it, with the given parameters, from t[0] on?"
            question = question or f"{self.name} is right along this motion: {integrated}"
            return TIGHT if has_coarse_steps(motion) else question
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
    """Fail unless the student's simulation follows the reference in every case; return the motions for further checks.

    reference : reference(t, *start, **parameters) -> rows, or several arrays of them; or a module, as for `compare`
    columns : default: those in `Assignment.returns`
    tolerance : largest error relative to the scale of each column
    hint    : where to look, or a function of the motion that returns it, if the rows do not show the mistake
    keeps   : an invariant that the student's page plots beside the error
    restart : restart(row) -> the arguments behind t that begin the motion there; default: the row, split like these
    near_miss_credit : False if an error of a few tolerances is no sign that the physics is right
    loose_tolerance_credit : False if wrong physics nearly obeys the equations, so that a small error proves nothing
    chaotic : accept a motion in which each row leads to the next, however far its errors have grown
    """
    columns = columns or function.returns.columns
    # a larger error leaves no share, whatever the other motions are
    hopeless = np.inf if chaotic else max(ROUGHLY, NEAR_MISS * tolerance)
    motions = _motions(function, reference, cases, columns, restart, hopeless)
    if not get_context().listens and max(motion.error for motion in motions) <= tolerance:
        return motions
    width = motions[0].expected.shape[1]
    turns = [index for column in columns if column.turns for index in np.arange(width)[column.where]]
    near_miss = NEAR_MISS * tolerance if near_miss_credit else 0.0

    def severity(motion: ComparedMotion) -> tuple[bool, int, float]:
        """Return the error or, if it leaves no share, first the length: the curve of the longest motion shows most."""
        has_no_share = motion.error > NEAR_MISS * tolerance
        return has_no_share, len(motion.actual) if has_no_share else 0, motion.error

    for motion in sorted(motions, key=severity, reverse=True):
        if chaotic and motion.error > tolerance and obeys(motion, everywhere=True):
            continue
        get_context().set_call(function.name, motion.case)
        for column in columns if not chaotic else ():
            where = np.arange(width)[column.where].tolist()
            scale = float(np.max(motion.scales[where]))
            limits = {"quantity": column.quantity, "scale": scale, "tolerance": tolerance}
            get_context().add_example(function, motion.case, None, where, motion.expected[:, where], **limits)
        # the column with the largest error, in its own unit
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
    """Fail unless invariants keep their initial values along motions that follow the reference coarsely.

    coarsely : tolerance relative to the scale of each column; if errors grow fast, rows that lead to the next suffice
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
    """Fail unless invariants keep their initial values along a student's motions."""
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
    """Return the student's motions, the longest first; only this one if its error is hopeless."""
    motions, true = list[ComparedMotion](), find_reference(reference, function)
    first, *rest = sorted(cases, key=lambda case: -len(case.args[0]))
    for some in filter(None, ([first], rest)):
        batch = Batch.of(true, some)
        scaled_rows = partial(batch.remembered, ("rows", *map(id, columns)), partial(_scaled_rows, batch, columns))
        try:
            compared = batch.compared(function, batch.results(function))
        except Failed as failed:
            case, rates = failed.failure.at, function.returns.rates
            # `is`: arrays cannot be compared by ==. If the function is no longer called, the case is an earlier one.
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
    """Return the columns, so that their ids in the cache key stay in use, and each case's expected rows and scales."""
    scaled_rows = []
    for case, expected in zip(batch.cases, map(flat, batch.expected), strict=True):
        scales = np.ones(expected.shape[1])  # of columns that `columns` does not describe
        for column in columns:
            scales[column.where] = column.size(case, expected)
        scaled_rows.append((expected, scales))
    return columns, scaled_rows


def loose_tolerance_share(motion: ComparedMotion, tolerance: float, size: float, error: float) -> float:
    """Return the share for right physics at a loose tolerance, which falls with the error; 0 for NaN."""
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
    # A motion by wrong rates needs no other explanation, for which many more are integrated.
    said = own_rates.source(motion) if own_rates else ""
    said = said or diagnosed(motion, motions, turns, near_miss, rates_are_right)
    said = said or (hint(motion) if callable(hint) else "")
    question = "" if callable(hint) else hint
    return said or (own_rates.hint(motion, question) if own_rates else question)


def _along(invariant: Invariant, motion: ComparedMotion) -> Curve | None:
    """Return the curve of an invariant along the student's motion, relative to its first value."""
    values = invariant.value(motion.actual, **motion.case.kwargs) / invariant.size(motion.case, motion.expected)
    words: Json = {"tolerance": invariant.tolerance, "quantity": invariant.quantity, "unit": invariant.unit}
    return curve(motion.case.args[0], values, np.broadcast_to(values[:1], values.shape), 1.0, **words)
