"""Values of formulas, and whether an equation of motion follows from the student's own Lagrangian."""

from collections.abc import Callable, Iterable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tam570.values import Numbers
from tam570_grader.checks.case import Case
from tam570_grader.checks.expect import Failed, FollowsFrom, NotWritten
from tam570_grader.checks.student import StudentFunction

STEP = 1e-3  # of x and of v; finite differences of doubles then err by 1e-6
FOLLOWS = 1e-4  # relative error; that of a wrong term is larger


def in_symbols(cases: Iterable[Case], *symbols: str) -> list[Case]:
    """Return the cases with their values as keywords, named by the symbols of a formula."""
    return [
        Case(**dict(zip(symbols, (*case.args, *case.kwargs.values()), strict=True))).labelled(case.label, case.hint)
        for case in cases
    ]


def from_own_lagrangian(student: Any, cases: Sequence[Case], otherwise: str) -> Callable[..., str]:
    """Return a hint for `lagrange_equation`: FollowsFrom if its wrong x'' is that of the student's own `lagrangian`.

    cases : their keywords are the Lagrangian's symbols; x and v are not zero
    """
    equation, lagrangian, points = student.lagrange_equation, student.lagrangian, [dict(case.kwargs) for case in cases]

    def hint(*_: Numbers) -> str:
        try:
            values = equation.at([{name: point[name] for name in equation.returns.symbols} for point in points])
            accelerations = _accelerations(lagrangian, points, *lagrangian.returns.symbols[:2])
        except (Failed, NotWritten):
            return otherwise
        follows = np.max(np.abs(values - accelerations) / np.abs(accelerations)) <= FOLLOWS
        return FollowsFrom(lagrangian.name) if follows else otherwise

    return hint


def _accelerations(lagrangian: StudentFunction, points: list[dict[str, float]], x: str, v: str) -> NDArray[np.float64]:
    """Return x'' = (L_x - L_vx v) / L_vv, by central differences."""
    shifts = [(i, j) for i in (-1, 0, 1) for j in (-1, 0, 1)]
    moved = [{**p, x: p[x] * (1 + i * STEP), v: p[v] * (1 + j * STEP)} for p in points for i, j in shifts]
    values = np.reshape(lagrangian.at(moved), (len(points), 3, 3))
    rates, steps = np.array([p[v] for p in points]), STEP * np.array([[p[x], p[v]] for p in points])
    by_x = (values[:, 2, 1] - values[:, 0, 1]) / (2 * steps[:, 0])
    by_both = (values[:, 2, 2] - values[:, 2, 0] - values[:, 0, 2] + values[:, 0, 0]) / (4 * steps[:, 0] * steps[:, 1])
    by_v_twice = (values[:, 1, 2] - 2 * values[:, 1, 1] + values[:, 1, 0]) / steps[:, 1] ** 2
    return np.asarray((by_x - by_both * rates) / by_v_twice)
