"""Hidden checks of single assignments: which answers they accept, and which they reject."""

import math
from types import SimpleNamespace

import numpy as np
import pytest
from parameters import first

from tam570_grader import Case
from tam570_grader.checks import assignments
from tam570_grader.checks.expect import Failed, check_context

HW03 = assignments.assignment(assignments.find(), "hw03_angular_momentum_rate")
CHECKS = {check.name: check for check in HW03.checks}
DRAW = np.random.default_rng(3)
ballistics = assignments.solution("hw02_ballistics")
BALL = {"mass": 1.7, "gravity": 9.81}  # kg, m/s^2
SPEED = 30.0  # m/s


def run_check(definition, p, c):
    """Run the hidden check on a student whose special motion has these coefficients of P and C."""
    motion = np.asarray(p, float), np.asarray(c, float)
    with np.errstate(all="ignore"):
        CHECKS[f"special_motion_of_{definition}"].run(SimpleNamespace(special_motion=lambda _: motion), None)


def turned(p, c, far=100.0):
    """Return the motion in a frame turned at random and far from the origin, so all coefficients are rounded."""
    matrix, shift = np.linalg.qr(DRAW.normal(size=(3, 3)))[0], DRAW.normal(size=3) * far
    p, c = (np.asarray(f, float) @ matrix.T for f in (p, c))
    p[0] += shift
    c[0] += shift
    return p, c


GROWING = [[0, 0, -2], [0, 0, 0.1]]
SPECIAL = {
    "P at rest, C speeding along a line": ("b", [[0, 1, 0]], [[0, 0, 0], [1, 0, 0], [1, 0, 0]]),
    "P at rest, C on a curve": ("b", [[5, 0, 1]], [[0, 0, 0], [0, 2, 0], [0, 0, 3], [1, 0, 0]]),
    "parallel lines": ("b", [[0, 1, 0], [2, 0, 0], [0, 0, 0], [-1, 0, 0]], [[0, 0, 0], [1, 0, 0], [1, 0, 0]]),
    "parallel lines, P uniform": ("b", [[0, 0, 1], [-1, 0, 0]], [[0, 0, 0], [-2, 0, 0], [1 / 3, 0, 0]]),
    "P twice as fast on a similar curve": ("b", [[0, 0, 1], *2 * np.eye(3)], [[0, 0, 0], *np.eye(3)]),
    "P above a thrown C": ("c", [[0, 1, 0], [1, 1, 0], [0, -1, 0]], [[0, 0, 0], [1, 0, 0], [0, -1, 0]]),
    "P below it, and falling": ("c", [[0, -1, 0], [1, 1, 0], [0, -3, 0]], [[0, 0, 0], [1, 1, 0], [0, -1, 0]]),
    "C about a uniform P": ("c", [[0, 0, 0], [0, 7, 0]], [[0, 0, 2], [0, 7, 0], [0, 0, -1]]),
    "C with an acceleration that grows": ("c", [[0, 0, 4], [1, 0, 2], *GROWING], [[0, 0, 0], [1, 0, 1], *GROWING]),
    "P at rest on the line of C": ("c", [[0, 0, 2]], [[0, 0, 0], [0, 0, 1], [0, 0, 0.25]]),
}
ON_ONE_LINE = SPECIAL.pop("P at rest on the line of C")  # b holds too


@pytest.mark.parametrize(("definition", "p", "c"), SPECIAL.values(), ids=SPECIAL.keys())
def test_any_special_motion_is_taken_for_its_definition_and_none_next_to_it(definition, p, c):
    """A special motion passes at any place, in any units and with appended zeros; with a disturbed P it fails."""
    run_check(definition, p, c)
    run_check(definition, np.vstack([p, np.zeros((4, 3))]), c)
    for far in (100.0, 100.0, 1e7):  # as far as the surface of the Earth is from its centre
        run_check(definition, *turned(p, c, far))
    for length in (1e-6, 1e6):
        run_check(definition, length * np.asarray(p), length * np.asarray(c))
    with pytest.raises(Failed, match="differ"):
        run_check({"b": "c", "c": "b"}[definition], p, c)
    p = np.vstack([p, np.zeros((3, 3))])
    away = 1e-6 * DRAW.normal(size=(3, 3))
    with pytest.raises(Failed, match="differ"):
        run_check(definition, p + np.pad(away, ((1, len(p) - 4), (0, 0))), c)
    p[1:4] += [[0.5, 0.25, 1], [0.25, 1, -0.5], [1, -0.5, 0.25]]
    for far in (1e7, 1e10, 1e13):
        with pytest.raises(Failed):
            run_check(definition, *turned(p, c, far))


X, LINE = [1, 0, 0], [[0, 0, 0], [1, 0, 0], [1, 0, 0]]
SEEMING = {
    "C at rest": ("b", [[0, 1, 0]], [[0, 0, 0]], "velocity of C"),
    "C uniform": ("b", [[0, 1, 0]], [[0, 0, 0], [1, 0, 0]], "acceleration of C"),
    "C stops at the start": ("b", [[0, 1, 0]], [[0, 0, 0], [0, 0, 0], [1, 0, 0]], "velocity of C"),
    "C stops at the end": ("b", [[0, 1, 0]], [[0, 0, 0], [-2, 0, 0], [1, 0, 0]], "velocity of C"),
    "C turns back": ("b", [[0, 1, 0]], [[0, 0, 0], [-0.3, 0, 0], [1, 0, 0]], "velocity of C vanishes at t = 0.15"),
    "C stops as (t - 1/3)^2": ("b", [[0, 1, 0]], np.outer([0, 1 / 9, -1 / 3, 1 / 3], X), "velocity of C .* t = 0.33"),
    "C's acceleration turns round": ("b", [[0, 1, 0]], np.outer([0, 9, -1, 0.5], X), "acceleration of C .* t = 0.67"),
    "an acceleration of roundings": ("b", [[0, 1, 0]], [[0, 0, 0], [1, 0, 0], [1e-16, 0, 0]], "acceleration of C"),
    "P is C": ("b", LINE, LINE, "meet"),
    "P meets C": ("b", [[0.75, 0, 0]], LINE, "meet at t = 0.5"),
    "P and C together": ("b", [[0, 1, 0], *LINE[1:]], LINE, "along with C"),
    "both hold": ("b", [[5, 0, 0], [2, 0, 0]], LINE, "Definition c has"),
    "both hold, P at rest": (*ON_ONE_LINE, "Definition b has"),
    "at t = 0 alone": ("b", [[0, 1, 0], [0, 0, 0], [0, 1, 0]], LINE, "differ"),
    "no property": ("c", [[0, 1, 0], [0, 0, 2]], LINE, "differ"),
    "a product that overflows": ("b", [[0, 0, 1e299], [0, 1e300, 0]], np.outer([0, 1e10, 1e6], X), "differ"),
    "too long": ("b", np.ones((101, 3)), LINE, "more than 100"),
}


@pytest.mark.parametrize(("definition", "p", "c", "flaw"), SEEMING.values(), ids=SEEMING.keys())
def test_none_that_only_seems_special_is_taken(definition, p, c, flaw):
    with pytest.raises(Failed, match=flaw):
        run_check(definition, p, c)
    with pytest.raises(Failed, match=flaw):
        run_check(definition, *turned(p, c))


def test_the_size_of_a_flight_back_at_launch_height_is_that_of_its_path():
    """The scale comes from the path, because the heights at both ends are 0, to which no error can be relative."""
    columns = assignments.assignment(assignments.find(), "hw02_ballistics").returns["simulate"].columns
    time = ballistics.flight_time(SPEED, math.pi / 2, drag=0.3, **BALL)
    call = Case(np.array([2.0, 2.0 + time]), SPEED, math.pi / 2, drag=0.3, **BALL)
    ends = ballistics.trajectory(call.args[0] - 2.0, *call.args[1:], **call.kwargs)
    top = ballistics.trajectory(np.linspace(0.0, time, 101), *call.args[1:], **call.kwargs)[:, 1].max()
    assert [column.scale(call, ends) for column in columns] == pytest.approx([top, top, SPEED, SPEED], rel=0.05)


HW07 = "hw07_double_pendulum"
TERMS = {"M": "mass_matrix_makes_the_kinetic_energy", "f": "velocity_terms_are_centripetal"}
TERMS["g"] = "gravity_terms_are_moments_of_the_weights"
COMBINED = """
lagranges = mass_matrix, velocity_terms, gravity_terms

def W(theta):
    return np.array({W})

def mass_matrix(theta, **known):
    return ({M}) @ lagranges[0](theta, **known)

def velocity_terms(theta, omega, **known):
    return ({f}) @ lagranges[1](theta, omega, **known)

def gravity_terms(theta, **known):
    return ({g}) @ lagranges[2](theta, **known)
"""
EQUATIONS = {
    "combined by the angles": "[[2 + math.sin(theta[0]), 1], [math.cos(theta[1]), -3]]",
    "Lagrange's": "[[1, 0], [0, 1]]",
    "about the ceiling and the elbow": "[[1, 1], [0, 1]]",
    "their sum and a scaled row of the other side": "[[1, 2], [0, -1e-3]]",
}


@pytest.fixture
def failed_terms(grade, solution_text):
    def failed_terms(W, **changed):
        factors = dict.fromkeys("Mfg", "W(theta)") | changed
        result = grade(HW07, solution_text(HW07) + COMBINED.format(W=W, **factors), naming=False)
        lost = {check.name for check in result.checks if check.outcome == "failed"}
        return {term for term, name in TERMS.items() if name in lost}

    return failed_terms


@pytest.mark.parametrize("W", first(2, EQUATIONS.values()), ids=EQUATIONS)
def test_any_two_independent_equations_are_right_and_the_wrong_term_alone_fails(W, failed_terms):
    assert failed_terms(W) == set()
    for term in TERMS:
        assert failed_terms(W, **{term: "W(theta) @ [[1, 0], [0.01, 1]]"}) == {term}


@pytest.mark.parametrize(
    ("W", "changed", "failed"),
    [
        ("[[1, 1], [2, 2]]", {}, set(TERMS)),  # one equation twice
        ("np.eye(2)", {"f": "-W(theta)", "g": "-W(theta)"}, {"f", "g"}),  # M has the opposite sign to f and g
        ("[[1, 1], [0, 1]]", {"M": "np.eye(2)"}, {"f", "g"}),  # Lagrange's M beside f and g of other equations
    ],
)
def test_terms_that_do_not_belong_together_fail(W, changed, failed, failed_terms):
    assert failed_terms(W, **changed) == failed


ENDLESS = "def mass_matrix(theta, **known): return [[1e200, 1e200], {}]"
AT_UNIT_RATES = """
def mass_matrix(theta, **known): return [[1, 2], [1, 2]]
def velocity_terms(theta, omega, **known): return [1e200, 1e-310] if omega[1] else [-1e200, -2e-310]
"""
NO_TERMS = """
def velocity_terms(theta, omega, **known): return [1, 2]
def gravity_terms(theta, **known): return [3, 4]
"""


@pytest.mark.parametrize(
    "terms", [ENDLESS.format("[1e-310, 2e-310]"), ENDLESS.format("[0, 0]"), AT_UNIT_RATES], ids=["tiny", "zero", "f"]
)
def test_equations_without_an_inverse_are_none(terms, grade):
    result = grade(HW07, NO_TERMS + terms, naming=False)
    assert {check.outcome for check in result.checks} <= {"failed", "not_run"} and result.score == 0


@pytest.mark.parametrize(("row", "words"), [(1, "y of Newton's law for bar 1"), (5, "on bar 2"), (7, "all ten?")])
def test_the_balance_that_does_not_hold_is_the_hint(row, words, student_of, solution_text):
    text = solution_text(HW07).replace("return right_side", f"right_side[{row}] += 1.0\n    return right_side")
    checks = {check.name: check for check in assignments.assignment(assignments.find(), HW07).checks}
    with check_context(), pytest.raises(Failed) as failed:
        checks["free_bars_accelerate_as_lagranges"].run(student_of(HW07, text), np.random.default_rng(5))
    assert words in failed.value.failure.hint
