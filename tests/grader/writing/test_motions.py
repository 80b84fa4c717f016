"""A chaotic motion with small errors has followed its equations; one that leaves them in a single row has not."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from tam570_grader.writing.check import given
from tam570_grader.writing.follow import loosely
from tam570_grader.writing.motions import Motion, obeys

LOOSE = """

def solve(rhs, t, y0, *, parameters=None, **_):
    from scipy.integrate import solve_ivp
    given = parameters or {}
    return solve_ivp(lambda s, y: rhs(s, y, **given), (t[0], t[-1]), y0, t_eval=t, rtol=1e-7, atol=1e-7).y.T
"""
TIMES = np.linspace(0, 30, 601)
START = np.array([1.0, 1.0, 20.0])


def lorenz(t, start, tolerance=1e-11):
    def rate(_, u):
        x, y, z = u
        return 10 * (y - x), x * (28 - z) - y, x * y - 8 / 3 * z

    return solve_ivp(rate, (t[0], t[-1]), start, "DOP853", t, rtol=tolerance, atol=tolerance).y.T


def motion(rows):
    return Motion(given(TIMES, START), rows, lorenz(TIMES, START), np.full(3, 20.0), None, lorenz)


def leads(rows):
    return obeys(motion(rows), everywhere=True)


@pytest.fixture(scope="module")
def loose():
    return lorenz(TIMES, START, 1e-5)


def test_errors_that_chaos_makes_large_break_no_equation(loose):
    assert np.abs(loose - lorenz(TIMES, START)).max() > 10
    assert leads(loose)


@pytest.mark.parametrize("row", [1, 300, 600])
def test_one_row_of_another_time_breaks_them(loose, row):
    loose = loose.copy()
    loose[row] = loose[(row + 100) % 601]
    assert not leads(loose)


def test_rows_in_another_order_or_at_rest_break_them(loose):
    assert not leads(loose[::-1])
    assert not leads(np.vstack([loose[:1], loose[:0:-1]]))
    assert not leads(np.tile(loose[0], (601, 1)))


@pytest.mark.full
def test_no_grade_leaps_between_ten_limits_and_a_tenth(loose):
    errors = np.geomspace(10, 1e5, 101)[1:] * 1e-6 * 20.0
    shares = np.array([loosely(motion(loose), 1e-6, 20.0, error) for error in errors])
    assert shares[0] == pytest.approx(0.9, abs=0.03)
    assert shares[-1] == 0.25
    assert np.all((np.diff(shares) >= -0.03) & (np.diff(shares) <= 0))
    assert [loosely(motion(loose), 1e-6, 20.0, error) for error in (2.1, np.nan, np.inf)] == [0.0, 0.0, 0.0]
    assert loosely(motion(loose[::-1]), 1e-6, 20.0, 1e-3) == 0.0


@pytest.mark.parametrize("number", [0, 2])
def test_the_energy_of_a_double_pendulum_is_judged_at_a_loose_tolerance(grade, solution_text, number):
    slug = "hw07_double_pendulum"
    marks = {mark.name: mark for mark in grade(slug, solution_text(slug) + LOOSE, number, naming=False).checks}
    assert marks["energy_is_conserved_from_horizontal"].points >= 0.9 * 0.5
