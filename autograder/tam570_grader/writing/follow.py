"""A simulated motion against the right one: what is compared, and what a wrong one is called."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tam570_grader.writing.agree import Column, Right, asked, named_in
from tam570_grader.writing.check import Given
from tam570_grader.writing.curves import kept
from tam570_grader.writing.expect import NEARLY, NEARLY_SHARE, OPENS, current, expect
from tam570_grader.writing.motions import ROUGHLY, Motion, diagnosed, flat, obeys

__all__ = ["Invariant", "follow", "stays"]

Array = NDArray[np.float64]
# Right physics at a loose tolerance keeps these shares of the points at these errors (of the scale), and in proportion
# to the logarithm of the error between them and ten limits, so that no grade leaps with the seed.
LOOSE = {1e-3: OPENS, ROUGHLY: 0.25}


@dataclass(frozen=True)
class Invariant:
    """What every right motion keeps: value(rows, **parameters) -> (n, ...), and the scale of its drift."""

    of: str  # "the energy"
    unit: str
    value: Callable[..., Array]
    scale: Callable[[Given, Array], float] | None  # scale(case, right rows); None: its value at the start, in size
    within: float

    def size(self, case: Given, rows: Array) -> float:
        """What its drift is relative to; 1 where that is zero."""
        start = self.scale(case, rows) if self.scale else np.linalg.norm(self.value(rows[:1], **case.kwargs))
        return float(start) or 1.0


def follow(
    function: Any,
    right: Right,
    cases: Iterable[Given],
    columns: Sequence[Column] = (),
    *,
    within: float,
    hint: str | Callable[[Motion], str] = "",
    keeps: Invariant | None = None,
    restart: Callable[[Array], tuple[Any, ...]] | None = None,
    gradual: bool = True,
    loose: bool = True,
    chaotic: bool = False,
) -> list[Motion]:
    """Fail unless the student's simulation follows the right motion in every case; the motions, for further checks.

    right   : right(t, *start, **parameters) -> rows, or several arrays of them; or the module, as for `agree`
    columns : left out, as RESULTS has them
    within  : of the scale of each column
    hint    : where to look, or a function of the motion that says it, if the rows themselves tell nothing
    keeps   : an invariant whose course the student's page draws beside the error
    restart : restart(row) -> the arguments behind t that begin the motion there; default: the row, cut as these are
    gradual : False where an error of a few limits is no sign that the physics is right
    loose   : False where wrong physics, too, nearly obeys the equations: a tenth of an error is then no sign
    chaotic : a motion in which each row leads to the next has followed, too, however far its errors have grown
    """
    columns = columns or function.promise.columns
    hopeless = np.inf if chaotic else max(ROUGHLY, NEARLY * within)  # no share is left, whatever the other motions are
    motions = _motions(function, right, cases, columns, restart, hopeless)
    width = motions[0].expected.shape[1]
    turns = [index for column in columns if column.turns for index in np.arange(width)[column.where]]
    # the worst first; of those beyond hope the longest, of which there is most to draw
    order, nearly = partial(_telling, within), NEARLY * within if gradual else 0.0
    for motion in sorted(motions, key=order, reverse=True):
        if chaotic and motion.error > within and obeys(motion, everywhere=True):
            continue
        current().judge(function.name, motion.case)
        _compare(motion, columns, within, partial(_hint, motion, motions, turns, nearly, hint), keeps, gradual, loose)
    return motions


def stays(
    function: Any,
    right: Right,
    cases: Iterable[Given],
    *invariants: Invariant,
    columns: Sequence[Column] = (),
    coarsely: float = 1e-2,
    partial: dict[float, float] | None = None,
    hint: str = "Use a tighter tolerance, or a smaller step",
) -> None:
    """Fail unless invariants keep their values at the start along motions that are followed coarsely.

    coarsely : of the scale of each column; where errors grow fast, it is enough that each row leads to the next
    """
    motions = follow(function, right, cases, columns, within=coarsely, hint=hint, gradual=False, chaotic=True)
    for invariant, motion in product(invariants, motions):
        case = motion.case
        start = invariant.value(motion.expected[:1], **case.kwargs)
        current().judge(function.name, case)
        expect(
            invariant.value(motion.found, **case.kwargs),
            np.broadcast_to(start, (len(motion.found), *np.shape(start)[1:])),
            within=invariant.within,
            scale=invariant.size(case, motion.expected),
            of=invariant.of,
            unit=invariant.unit,
            t=case.args[0],
            partial=partial,
            hint=hint,
        )


def _motions(
    function: Any, right: Right, cases: Iterable[Given], columns: Sequence[Column], restart: Any, hopeless: float
) -> list[Motion]:
    """The student's motions, the longest first; where its error is hopeless, the others are not asked for."""
    motions, true = list[Motion](), named_in(right, function)
    first, *rest = sorted(cases, key=lambda case: -len(case.args[0]))
    for some in filter(None, ([first], rest)):
        for case, found, rows in asked(function, right, some):
            expected = flat(rows)
            scales = _scales(columns, case, expected)
            motions.append(Motion(case, flat(found), expected, scales, function, true, restart))
        if motions[0].error > hopeless and not current().recorder:
            break
    return motions


def _telling(within: float, motion: Motion) -> tuple[bool, int, float]:
    hopeless = motion.error > NEARLY * within
    return hopeless, len(motion.found) if hopeless else 0, motion.error


def _scales(columns: Sequence[Column], case: Given, expected: Array) -> Array:
    """(k,) the scale of each column; 1 where all is zero."""
    scales = np.ones(expected.shape[1])
    for column in columns:
        largest = np.max(np.abs(expected[:, column.where]))
        scales[column.where] = (column.scale(case, expected) if column.scale else largest) or 1.0
    return scales


def _compare(
    motion: Motion,
    columns: Sequence[Column],
    within: float,
    hint: Any,
    keeps: Invariant | None,
    gradual: bool,
    loose: bool,
) -> None:
    """Judge the column that is off most, in its own unit."""
    where = [column.where for column in columns]
    worst = int(np.argmax([np.max(motion.errors[:, place], initial=0.0) for place in where]))
    size, column = float(np.max(motion.scales[where[worst]])), columns[worst]
    expect(
        motion.found[:, column.where],
        motion.expected[:, column.where],
        within=within * size,
        of=column.of,
        unit=column.unit,
        t=motion.case.args[0],
        partial=partial(loosely, motion, within, size) if gradual and loose else None,
        gradual=gradual,
        hint=hint,
        keeps=partial(_along, keeps, motion) if keeps else None,
    )


def loosely(motion: Motion, within: float, size: float, error: float) -> float:
    """Right physics at a loose tolerance keeps a share that falls with the error; a NaN keeps nothing."""
    if not (error <= ROUGHLY * size and obeys(motion)):
        return 0.0
    known = {NEARLY * within: NEARLY_SHARE} | {
        limit: share for limit, share in LOOSE.items() if limit > NEARLY * within
    }
    return round(float(np.interp(np.log(error / size), np.log(list(known)), list(known.values()))), 2)


def _hint(motion: Motion, motions: Sequence[Motion], turns: Sequence[int], nearly: float, hint: Any) -> str:
    return diagnosed(motion, motions, turns, nearly) or (hint(motion) if callable(hint) else hint)


def _along(invariant: Invariant, motion: Motion) -> Any:
    values = invariant.value(motion.found, **motion.case.kwargs) / invariant.size(motion.case, motion.expected)
    return kept(motion.case.args[0], values, within=invariant.within, of=invariant.of, unit=invariant.unit)
