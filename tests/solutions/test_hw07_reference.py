"""The motion that the grader holds students to in hw07: by its other equations, and by SciPy's integrator."""

import sys

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from tam570_grader.checks import assignments

DRAW = np.random.default_rng(7)


@pytest.fixture(scope="module")
def reference(course):
    assert assignments.assignment(course, "hw07_double_pendulum").checks
    return sys.modules["_checks_hw07_double_pendulum.reference"]


@pytest.fixture
def known():
    return {"masses": DRAW.uniform(0.5, 4, 2), "lengths": DRAW.uniform(0.3, 2, 2), "gravity": DRAW.uniform(0, 20)}


@pytest.mark.parametrize("_", range(20))
def test_its_equations_are_dalemberts(reference, known, _):
    theta, omega = DRAW.uniform(-4, 4, 2), DRAW.uniform(-5, 5, 2)
    derivative = reference.rates(0.0, [*theta, *omega], **known)
    expected = [*omega, *reference.angular_acceleration(theta, omega, **known)]
    np.testing.assert_allclose(derivative, expected, rtol=1e-11, atol=1e-11)  # rounding


def test_its_motion_is_scipys(reference, known):
    theta, omega, t = DRAW.uniform(-1, 1, 2), DRAW.uniform(-1, 1, 2), np.linspace(-1.3, 1.7, 40)

    def rates(_, state):
        return [*state[2:], *reference.angular_acceleration(state[:2], state[2:], **known)]

    start = np.concatenate([theta, omega])
    expected = solve_ivp(rates, t[[0, -1]], start, method="DOP853", t_eval=t, rtol=1e-11, atol=1e-11).y.T
    # a hundredth of the limit to which students are held; the two were 1e-9 apart in a hundred motions
    np.testing.assert_allclose(reference.simulate(t, theta, omega, **known), expected, rtol=0, atol=1e-6)
