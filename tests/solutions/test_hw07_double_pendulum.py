"""hw07's solution: fifty digits, the massless limit."""

import math

import mpmath as mp
import numpy as np
import pytest
from scipy.special import ellipj, ellipk

from tam570_grader.checks import assignments

pendulum = assignments.solution("hw07_double_pendulum")

OMEGA = np.array([-1.7, 2.9])  # rad/s
STILL = np.zeros(2)
ROUNDING = 1e-13  # relative; a dozen roundings make 1e-15


def exact_acceleration(theta, omega, masses, lengths, gravity):
    """From the matrix and the terms, all with 50 digits."""
    m1, m2, l1, l2, th1, th2, om1, om2, g = map(mp.mpf, map(float, (*masses, *lengths, *theta, *omega, gravity)))
    coupling = m2 * l1 * l2 / 2
    c, s = coupling * mp.cos(th1 - th2), coupling * mp.sin(th1 - th2)
    M = mp.matrix([[(m1 / 3 + m2) * l1**2, c], [c, m2 * l2**2 / 3]])
    weights = g * (m1 / 2 + m2) * l1 * mp.sin(th1), g * m2 * l2 / 2 * mp.sin(th2)
    pull = mp.matrix([-s * om2**2 - weights[0], s * om1**2 - weights[1]])
    return np.array([float(x) for x in mp.lu_solve(M, pull)])


@pytest.mark.parametrize("masses", [(1.0, 1.0), (1.0, 1e-9), (1e-9, 1.0), (1e-6, 1e6), (1e6, 1e-6)])
@pytest.mark.parametrize("lengths", [(1.0, 1.0), (1e-3, 1e3), (1e3, 1e-3)])
@pytest.mark.parametrize("theta", [(0.3, -2.0), (1.0, 1.0), (1.0, 1.0 + 1e-9)])
def test_accelerations_against_fifty_digits(masses, lengths, theta):
    parameters = {"masses": np.array(masses), "lengths": np.array(lengths), "gravity": 9.81}
    exact = exact_acceleration(theta, OMEGA, **parameters)
    size = (np.max(lengths * OMEGA**2) + 9.81) / np.array(lengths) * 12  # determinants go down to 1/12
    lagrangian = pendulum.angular_acceleration(np.array(theta), OMEGA, **parameters)
    free, _ = pendulum.on_the_fly(np.array(theta), OMEGA, **parameters)
    assert np.all(np.abs(lagrangian - exact) <= ROUNDING * size)
    assert np.all(np.abs(free - exact) <= 10 * ROUNDING * size)  # ten equations round more


@pytest.mark.parametrize("light", [1e-9, 1e-12])
def test_under_a_massless_bar_bar_1_is_a_compound_pendulum(light):
    """Released at 2 rad: sin(th/2) = sin(1) sn(K - w t), w^2 = 3 g/(2 l). The light bar disturbs by its mass."""
    parameters = {"masses": np.array([1.3, 1.3 * light]), "lengths": np.array([0.9, 0.6]), "gravity": 9.81}
    t, m = np.linspace(0.0, 4.0, 41), math.sin(1.0) ** 2
    sn, *_ = ellipj(ellipk(m) - math.sqrt(1.5 * 9.81 / 0.9) * t, m)
    result = pendulum.simulate(t, np.array([2.0, -0.5]), STILL, **parameters)[:, 0]
    np.testing.assert_allclose(result, 2 * np.arcsin(math.sin(1.0) * sn), atol=1e3 * light + 1e-10)


def exact_frequencies(masses, lengths, gravity):
    """By the roots of det(K - w^2 M) with 50 digits."""
    (m1, m2), (l1, l2) = map(mp.mpf, map(float, masses)), map(mp.mpf, map(float, lengths))
    M = (m1 / 3 + m2) * l1**2, m2 * l1 * l2 / 2, m2 * l2**2 / 3
    k1, k2 = gravity * (m1 / 2 + m2) * l1, gravity * m2 * l2 / 2
    squares = mp.polyroots([M[0] * M[2] - M[1] ** 2, -(M[0] * k2 + M[2] * k1), k1 * k2], maxsteps=200, extraprec=200)
    return sorted(float(mp.sqrt(mp.re(square))) for square in squares)


@pytest.mark.parametrize("masses", [(1.0, 1.0), (0.3, 4.0), (1.0, 1e-9), (1e-9, 1.0), (1e6, 1e-6)])
@pytest.mark.parametrize("lengths", [(1.0, 1.0), (1.0, 1.6), (1e-3, 1e3), (1e6, 1e-6)])
def test_frequencies_against_fifty_digits(masses, lengths):
    exact = exact_frequencies(masses, lengths, mp.mpf(9.81))
    result = pendulum.small_oscillation_frequencies(masses=masses, lengths=lengths, gravity=9.81)
    np.testing.assert_allclose(result, exact, rtol=ROUNDING)
