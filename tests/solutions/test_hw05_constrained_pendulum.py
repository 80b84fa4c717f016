"""hw05's solution against fifty digits of mpmath."""

import math

import mpmath
import numpy as np
import pytest

from tam570_grader.checks import assignments

hw = assignments.solution("hw05_constrained_pendulum")
DRAW = np.random.default_rng(5)
ROUNDINGS = 1e-13  # relative to the largest term


@pytest.mark.parametrize("gravity", [0.0, 9.3, 30.0])
def test_force_and_acceleration_have_full_digits(gravity):
    """Route: the linear system of F = m a and r . a + v . v = 0, solved in mpmath, over twelve decades.

    The state is on the circle but for roundings, which move the solution by as much.
    """
    for mass, length in 10 ** DRAW.uniform(-6, 6, (5, 2)):
        pendulum = {"mass": mass, "length": length, "gravity": gravity}
        theta, omega = DRAW.uniform(-4, 4), DRAW.normal() * math.sqrt((gravity or 1.0) / length)
        c, s = math.cos(theta), math.sin(theta)
        state = length * np.array([s, -c, omega * c, omega * s])
        m, g, x, y, vx, vy = (mpmath.mpf(q) for q in (mass, gravity, *state))
        system = mpmath.matrix([[m, 0, -x], [0, m, -y], [x, y, 0]])
        ax, ay, pull = mpmath.lu_solve(system, mpmath.matrix([0, -m * g, -(vx**2) - vy**2]))
        results = [*hw.acceleration(state, **pendulum), *hw.constraint_force(state, **pendulum) / mass]
        for result, expected in zip(results, (ax, ay, pull * x / m, pull * y / m), strict=True):
            assert abs(result - expected) <= ROUNDINGS * (state[2:] @ state[2:] / length + gravity)


def test_a_consistent_state_is_the_nearest():
    """Route: projections in mpmath; no point of the circle is nearer, no tangent velocity either."""
    for length in 10.0 ** DRAW.uniform(-6, 6, 12):
        state = DRAW.normal(size=4) * 10 ** DRAW.uniform(-6, 6, 4)
        x, y, vx, vy = (mpmath.mpf(q) for q in state)
        d = mpmath.hypot(x, y)
        across = (x * vy - y * vx) / d**2
        expected = (x / d * length, y / d * length, -across * y, across * x)
        scales = np.array([length, length, *[math.hypot(*state[2:])] * 2])
        result = hw.consistent_state(state, length=length)
        assert all(abs(a - b) <= 4e-15 * scale for a, b, scale in zip(result, expected, scales, strict=True))
        repeated = hw.consistent_state(result, length=length)
        np.testing.assert_allclose(repeated / scales, result / scales, rtol=0, atol=4e-15)
