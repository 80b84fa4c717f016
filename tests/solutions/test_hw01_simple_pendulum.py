"""hw01's solution against fifty digits: the balances over twelve decades, elliptic functions."""

import math

import mpmath
import numpy as np
import pytest

from tam570_grader.checks import assignments

hw = assignments.solution("hw01_simple_pendulum")
DRAW = np.random.default_rng(1)
PENDULUM = {"length": 1.7, "gravity": 9.3}  # m, m/s^2
RATE = mpmath.sqrt(mpmath.mpf(9.3) / mpmath.mpf(1.7))  # 1/s
ROUNDINGS = 1e-13  # relative, of a closed form
TINY, NEXT_TO_TOP = 1e-8, math.pi - 1e-8  # rad


def test_the_balances_hold_to_the_last_digits():
    """Route: the same quantities from r, v, F in mpmath."""
    for theta in [*DRAW.uniform(-20, 20, 80), 0.0, TINY, NEXT_TO_TOP]:
        mass, length, omega = *10 ** DRAW.uniform(-6, 6, 2), DRAW.normal() * 3
        pendulum = {"mass": mass, "length": length, "gravity": DRAW.uniform(0, 30)}
        m, r, g, th, om = (mpmath.mpf(x) for x in (*pendulum.values(), theta, omega))
        s, c = mpmath.sin(th), mpmath.cos(th)
        expected = {
            "linear_momentum_balance": (-g / r * s, m * r * om**2 + m * g * c),
            "angular_momentum_balance": (-g / r * s, m * r**2 * om, -m * g * r * s),
            "energy_balance": (-g / r * s, m * (r * om) ** 2 / 2, m * g * r * (1 - c)),
            "power_balance": (-g / r * s, -m * g * r * s * om),
            "virtual_work": (-g / r * s, -m * g * r * s),
        }
        largest = {"linear_momentum_balance": (0, m * r * om**2 + m * g)}  # what the tension's two terms are rounded to
        for name, values in expected.items():
            scales = largest.get(name, (0,) * len(values))
            for result, value, scale in zip(getattr(hw, name)(theta, omega, **pendulum), values, scales, strict=True):
                assert abs(result - value) <= ROUNDINGS * max(abs(value), scale)


@pytest.mark.parametrize("amplitude", [TINY, 1e-3, 0.5, 1.0, 2.0, 3.0, math.pi - 1e-3, NEXT_TO_TOP])
def test_the_period_is_an_elliptic_integral(amplitude):
    """Route: Legendre's K in mpmath."""
    expected = 4 / RATE * mpmath.ellipk(mpmath.sin(mpmath.mpf(amplitude) / 2) ** 2)
    assert abs(hw.period(amplitude, **PENDULUM) / expected - 1) < ROUNDINGS


def test_the_motion_is_an_elliptic_function():
    """Route: Jacobi's sn in mpmath, swinging from the bottom."""
    omega0, t = 1.3 * float(RATE), np.sort(DRAW.uniform(0, 30, 20))
    k = mpmath.mpf(omega0) / (2 * RATE)
    expected = [2 * mpmath.asin(k * mpmath.ellipfun("sn", RATE * mpmath.mpf(time), m=k**2).real) for time in t]
    result = hw.simulate(np.append(0.0, t), 0.0, omega0, **PENDULUM)[1:, 0]
    np.testing.assert_allclose(result, np.array(expected, float), rtol=0, atol=1e-11)
