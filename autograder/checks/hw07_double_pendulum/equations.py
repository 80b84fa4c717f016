"""[M], {f}, {g} of any two independent equations of motion: Lagrange's terms times an invertible W(theta).

A term is right if it is Lagrange's, or if it belongs to the student's other two terms. W^-1 turns it back into
Lagrange's before it is compared, so that tolerances, messages and known mistakes are those of Lagrange's equations.
"""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tam570_grader import Failed, expect, get_context
from tam570_grader.checks.case import Case
from tam570_grader.checks.compare import Batch, trim_to_signature
from tam570_grader.checks.expect import NotWritten
from tam570_grader.checks.expected import expected_result

from . import reference

Array = NDArray[np.float64]
M, F, G = TERMS = ("mass_matrix", "velocity_terms", "gravity_terms")
DEPENDENT = 1e-9  # determinant of rows of unit length: with a smaller one, two equations are dependent
OBLIQUE = 0.2  # sine of the angle between the bars: with a larger one, {f} at unit rates gives W
SAME_TWO = "Your other two terms are of two equations that are not Lagrange's; this one does not fit them"
CONTRADICTED = "It contradicts your third term: are all three from the same two equations, on the same side?"


def agree_in_equations(function: Any, cases: Sequence[Case], *, tolerance: float, hint: str) -> None:
    """Fail unless a term is Lagrange's, or belongs to the student's other two terms."""
    student, words = function.student, function.returns.description
    equations = Equations(student, cases, tolerance)
    results, last = equations.term(function.name), len(student.calls)
    back, hint = equations.back(function.name, hint)
    true, sizes = equations.lagranges(function.name), equations.sizes(function.name)
    definite = np.flatnonzero(np.isfinite(back).all((1, 2)))
    calls = student.calls[last - len(cases) :]
    brought = [replace(calls[i], result=(back[i] @ results[i]).reshape(true[i].shape)) for i in definite]
    student.calls[last - len(cases) :] = brought  # known mistakes are compared with these
    for call, correct, size in zip(brought, true[definite], sizes[definite], strict=True):
        get_context().set_call(function.name, call.case)
        expect(call.result, correct, tolerance=tolerance * size, quantity=words.quantity, unit=words.unit, hint=hint)


class Equations:
    """The student's two equations of motion in some cases, beside Lagrange's; vectors are (n, 2, 1)."""

    def __init__(self, student: Any, cases: Sequence[Case], tolerance: float) -> None:
        self._student, self._cases, self._within = student, cases, tolerance
        self._terms = dict[str, Array | None]()

    def term(self, name: str) -> Array:
        """Return (n, 2, k), a term of the student's; raise Failed or NotWritten if the function gives none."""
        results = getattr(self._student, name).many(self._batch(name).cases)
        self._terms[name] = _columns(results)
        return _columns(results)

    def lagranges(self, name: str) -> Array:
        """Return (n, 2) or (n, 2, 2), Lagrange's term."""
        return np.array(self._batch(name).expected)

    def sizes(self, name: str) -> Array:
        """Return (n,), the scale of a term in each case."""
        size, batch = getattr(self._student, name).returns.description.scale, self._batch(name)
        return np.array(batch.remembered(size, lambda: [size(case) for case in batch.cases]))

    def _batch(self, name: str) -> Batch:
        return Batch.of(getattr(reference, name), self._cases)

    def back(self, name: str, hint: str) -> tuple[Array, str]:
        """Return (n, 2, 2), W^-1 of the equations in which a term is judged, NaN if unknown; and where to look."""
        lagranges = np.broadcast_to(np.eye(2), (len(self._cases), 2, 2))
        if self._holds(name, lagranges):
            return lagranges, hint
        others = [other for other in TERMS if other != name]
        for partner, third in (others, others[::-1]):
            back = self._back_of(name, partner)
            if back is not None:
                contradicted = self._holds(third, lagranges) and not self._holds(third, back)
                return (lagranges, CONTRADICTED) if contradicted else (back, hint)
        back = self._back_of(*others)
        return (lagranges, hint) if back is None or self._holds(others[0], lagranges) else (back, SAME_TWO)

    def _back_of(self, *names: str) -> Array | None:
        """Return W^-1 of the two equations to which both terms belong; None if there are none."""
        first, second = sorted(names, key=TERMS.index)
        back = self._back_of_masses() if first == M else self._back_of_rates()
        return back if back is not None and self._holds(second, back) else None

    def _back_of_masses(self) -> Array | None:
        """Return W^-1 for W = M M_L^-1."""
        mine = self._term(M)
        return None if mine is None else _times_inverse(self.lagranges(M), mine)

    def _back_of_rates(self) -> Array | None:
        """Return W^-1 by {f} at unit rates, k times a column of W: Lagrange's {f} is (k om2^2, -k om1^2)."""
        at_rates = [[case.replace(case.args[0], unit) for case in self._cases] for unit in np.eye(2)]
        first, second = (self._tried(F, cases) for cases in at_rates)
        if first is None or second is None:
            return None
        k = [
            expected_result(reference.velocity_terms, case)[0]
            for case in trim_to_signature(reference.velocity_terms, at_rates[1])
        ]
        columns = np.concatenate([second, -first], axis=2) / np.reshape(k, (-1, 1, 1))
        theta = np.array([case.args[0] for case in self._cases])
        unknown = np.abs(np.sin(theta[:, 0] - theta[:, 1])) < OBLIQUE
        columns[unknown] = np.eye(2)
        back = _times_inverse(np.broadcast_to(np.eye(2), columns.shape), columns)
        return None if back is None else np.where(unknown[:, None, None], np.nan, back)

    def _holds(self, name: str, back: Array) -> bool:
        """Return whether a term, turned back by W^-1, is Lagrange's wherever W^-1 is known."""
        mine = self._term(name)
        if mine is None:
            return False
        error = np.abs(back @ mine - _columns(self.lagranges(name))).max((1, 2))
        definite = np.isfinite(back).all((1, 2))
        return bool(definite.any() and (error[definite] <= self._within * self.sizes(name)[definite]).all())

    def _term(self, name: str) -> Array | None:
        """Return a term of the student's; None if the function gives none."""
        if name not in self._terms:
            self._terms[name] = self._tried(name, self._cases)
        return self._terms[name]

    def _tried(self, name: str, cases: Sequence[Case]) -> Array | None:
        """Return results of calls that are not judged here; None if they fail."""
        calls = len(self._student.calls)
        try:
            return _columns(getattr(self._student, name).many(trim_to_signature(getattr(reference, name), cases)))
        except (Failed, NotWritten):
            return None
        finally:
            del self._student.calls[calls:]


def _columns(results: Any) -> Array:
    """Return (n, 2, k) results, a vector as one column."""
    array = np.array(results, float)
    return array if array.ndim == 3 else array[:, :, None]


def _times_inverse(first: Array, second: Array) -> Array | None:
    """Return first second^-1 of each case; None if two rows of second are dependent in a case, or have no inverse."""
    sizes = np.abs(second).max(axis=2, keepdims=True)
    rows = second / sizes  # before anything is squared, which may overflow
    lengths = np.linalg.norm(rows, axis=2).prod(axis=1)
    if not (np.abs(np.linalg.det(rows)) > DEPENDENT * lengths).all():  # nor if they are NaN
        return None
    inverse = first @ (np.linalg.inv(rows) / np.swapaxes(sizes, 1, 2))
    return inverse if np.isfinite(inverse).all() else None
