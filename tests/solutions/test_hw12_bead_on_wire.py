"""hw12's solution against fifty digits of mpmath: constrained motion over many decades, Legendre's E."""

import math

import mpmath
import numpy as np
import pytest

from tam570_grader.checks import assignments

hw = assignments.solution("hw12_bead_on_wire")
DRAW = np.random.default_rng(1)
WIRE = {"curvature": 0.37, "gravity": 9.3}  # 1/m, m/s^2
ROUNDINGS = 1e-13  # relative, of a closed form


def test_acceleration_force_and_energy_are_those_of_constrained_motion():
    """Route: the linear system for x'', y'' and the multiplier of y - c x^2 = 0, in mpmath, over many decades."""
    for _ in range(40):
        c, g = 10 ** DRAW.uniform(-6, 6), DRAW.uniform(1, 30) * DRAW.choice([0, 1], p=[0.2, 0.8])
        x, v = DRAW.choice([-1, 1]) * 10 ** DRAW.uniform(-8, 4) / c, DRAW.normal() * math.sqrt(10 / c)
        m = 10 ** DRAW.uniform(-6, 6)
        X, V, M, C, G = map(mpmath.mpf, (x, v, m, c, g))
        system = mpmath.matrix([[M, 0, 2 * C * X], [0, M, -1], [-2 * C * X, 1, 0]])
        ax, _, multiplier = mpmath.lu_solve(system, mpmath.matrix([0, -M * G, 2 * C * V**2]))
        result = hw.acceleration_newton(x, v, curvature=c, gravity=g)
        assert abs(result - ax) <= ROUNDINGS * abs(ax)
        force = hw.constraint_force(x, v, mass=m, curvature=c, gravity=g)
        assert abs(force[0] + 2 * C * X * multiplier) <= ROUNDINGS * abs(2 * C * X * multiplier)
        assert abs(force[1] - multiplier) <= ROUNDINGS * abs(multiplier)
        expected = M * (V**2 + (2 * C * X * V) ** 2) / 2 + M * G * C * X**2
        assert abs(hw.energy(x, v, mass=m, curvature=c, gravity=g) - expected) <= ROUNDINGS * expected


@pytest.mark.parametrize("steepness", [1e-8, 1e-5, 1e-3, 0.1, 0.5, 1.0, 10.0, 1e3, 1e4])
def test_the_period_is_an_elliptic_integral(steepness):
    """Route: Legendre's E in mpmath; the steepness is curvature times amplitude."""
    amplitude = steepness / 0.37
    c, g = mpmath.mpf(0.37), mpmath.mpf(9.3)
    expected = 4 * mpmath.ellipe(-((2 * c * mpmath.mpf(amplitude)) ** 2)) / mpmath.sqrt(2 * g * c)
    assert abs(hw.period(amplitude, **WIRE) / expected - 1) < ROUNDINGS
