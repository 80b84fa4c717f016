"""Stiff equations neither hang nor lie: what ends in time is right, the rest is told with its remedy."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from tam570.integrate import solve


def van_der_pol(t, y, *, stiffness):
    return y[1], stiffness * (1 - y[0] ** 2) * y[1] - y[0]


def robertson(t, y):
    a, b, c = y
    return -0.04 * a + 1e4 * b * c, 0.04 * a - 1e4 * b * c - 3e7 * b * b, 3e7 * b * b


def hires(t, y):
    a, b, c, d, e, f, g, h = y
    bound = 280 * f * h - 1.81 * g
    return (
        -1.71 * a + 0.43 * b + 8.32 * c + 0.0007,
        1.71 * a - 8.75 * b,
        -10.03 * c + 0.43 * d + 0.035 * e,
        8.32 * b + 1.71 * c - 1.12 * d,
        -1.745 * e + 0.43 * f + 0.43 * g,
        -280 * f * h + 0.69 * d + 1.71 * e - 0.43 * f + 0.69 * g,
        bound,
        -bound,
    )


HIRES = [1.0, 0, 0, 0, 0, 0, 0, 0.0057]


def by_radau(rhs, end, start, **parameters):
    result = solve_ivp(lambda t, y: rhs(t, y, **parameters), (0, end), start, method="Radau", rtol=1e-10, atol=1e-14)
    return result.y[:, -1]


@pytest.mark.parametrize("method", ["python", "auto"])
@pytest.mark.parametrize(
    ("rhs", "end", "start", "parameters"),
    [
        (van_der_pol, 1e8, [2.0, 0.0], {"stiffness": 1e5}),
        (van_der_pol, 3e9, [2.0, 0.0], {"stiffness": 1e3}),
        (robertson, 1e11, [1.0, 0.0, 0.0], {}),
    ],
)
def test_what_would_never_end_is_told_with_its_remedy(method, rhs, end, start, parameters):
    with pytest.raises(ArithmeticError, match=r"stiff at t = .*Radau.*LSODA"):
        solve(rhs, [0, end], start, parameters=parameters, method=method, rtol=1e-8)


@pytest.mark.parametrize("method", ["python", "auto"])
@pytest.mark.parametrize(("rhs", "end", "start"), [(robertson, 10.0, [1.0, 0.0, 0.0]), (hires, 321.8122, HIRES)])
def test_what_ends_in_time_is_right(method, rhs, end, start):
    states = solve(rhs, [0, end], start, method=method, rtol=1e-9)
    assert states[-1] == pytest.approx(by_radau(rhs, end, start), rel=1e-6, abs=1e-11)


@pytest.mark.parametrize("rtol", [1e-3, 1e-10])
def test_a_long_oscillation_is_not_called_stiff(rtol):
    """A fast one in the imaginary direction, damped a little: a million steps are left, and nobody is sent away."""
    seen = []

    def rates(t, y):
        seen.append(0)
        if len(seen) > 200_000:
            raise KeyboardInterrupt
        return y[1], -1e4 * y[0] - 0.01 * y[1] + (0.0 if y[0] > -9 else 1.0)

    with pytest.raises(KeyboardInterrupt):
        solve(rates, [0, 1e6], [1.0, 0.0], rtol=rtol)


@pytest.mark.parametrize(("decay", "end"), [(5e4, 30.0), (3e5, 3.0)])
def test_a_stiff_phase_that_passes_is_stepped_through_and_right_from_the_start(decay, end):
    """Fast in the beginning only: the first step looks thousands of times too far, and must leave no scale behind."""

    def rates(t, y):
        return (-(decay if t < 0.1 else 1.0) * (y[0] - np.cos(t)) - np.sin(t),)

    t = np.array([0.0, 0.02, 0.05, 0.08, end])
    states = solve(rates, t, [1.0], rtol=1e-9)
    assert np.abs(states[:, 0] - np.cos(t)).max() < 1e-8
