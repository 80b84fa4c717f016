"""What starts at zero has a scale: chains that a motion runs along, forces that set in late, jumps in time.

Each is compared with an exact solution, or with SciPy's DOP853 at its best tolerance.
"""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from tam570.integrate import solve


def chain(masses):
    """Masses of 1 kg between springs of 1 N/m, the ends fixed."""

    def rates(t, y):
        x = [0.0, *y[:masses], 0.0]
        return [*y[masses:], *(x[i - 1] - 2 * x[i] + x[i + 1] for i in range(1, masses + 1))]

    return rates


def chain_exactly(masses, start, t):
    """By its normal modes."""
    stiffness = 2 * np.eye(masses) - np.eye(masses, k=1) - np.eye(masses, k=-1)
    squares, modes = np.linalg.eigh(stiffness)
    rates, parts = np.sqrt(squares), modes.T @ start[:masses]
    phases = np.outer(t, rates)
    return np.hstack([parts * np.cos(phases) @ modes.T, -parts * rates * np.sin(phases) @ modes.T])


def unit(size, index, value=1.0):
    state = np.zeros(size)
    state[index] = value
    return state


@pytest.mark.parametrize("masses", [4, 6, 7, 8, 9, 10, 30])
@pytest.mark.parametrize("rtol", [1e-6, 1e-10, 1e-13])
def test_masses_on_springs_with_the_first_displaced(masses, rtol):
    t, start = np.linspace(0, 20, 41), unit(2 * masses, 0)
    states = solve(chain(masses), t, start, rtol=rtol)
    assert np.abs(states - chain_exactly(masses, start, t)).max() < 10 * rtol


@pytest.mark.parametrize("size", [1e-9, 1.0, 1e11])
def test_a_chain_of_any_size_is_judged_by_its_own(size):
    t, start = np.linspace(0, 20, 11), unit(16, 0, size)
    states = solve(chain(8), t, start)
    assert np.abs(states - chain_exactly(8, start, t)).max() < 1e-9 * size


def by_scipy(rates, t, start, **options):
    """SciPy's DOP853 at its best tolerance; `given` changes it."""
    result = solve_ivp(
        rates, (t[0], t[-1]), start, t_eval=t, **{"method": "DOP853", "rtol": 3e-14, "atol": 1e-16, **options}
    )
    assert result.success
    return result.y.T


def fermi_pasta_ulam(t, y):
    """16 masses, springs with a quadratic and a cubic part: what the linear part does not reach must not be missed."""
    x = [0.0, *y[:16], 0.0]
    stretch = [b - a for a, b in zip(x, x[1:], strict=False)]
    pull = [d + 0.25 * d * d + d * d * d for d in stretch]
    return [*y[16:], *(b - a for a, b in zip(pull, pull[1:], strict=False))]


def heat(t, y):
    u = [0.0, *y, 0.0]
    return [u[i - 1] - 2 * u[i] + u[i + 1] for i in range(1, len(y) + 1)]


def cascade(t, y):
    """Each drives the next by its square: at the start no rate changes with any state but the first."""
    return [-y[0], *(a * a - b for a, b in zip(y, y[1:], strict=False))]


@pytest.mark.parametrize(
    ("rates", "start", "end"),
    [
        (fermi_pasta_ulam, unit(32, 16), 20),
        (heat, unit(50, 25), 5),  # C4 has 51 from the edge
        (heat, unit(50, 0), 5),
        (lambda t, y: [-y[0], *(y[i - 1] - y[i] for i in range(1, 9)), y[8]], unit(10, 0), 20),
        (lambda t, y: [-y[0], *(i * y[i - 1] - (i + 1) * y[i] for i in range(1, 9)), 9 * y[8]], unit(10, 0), 20),
        (heat, unit(10, 0), 20),  # C3
        (heat, unit(51, 0), 20),  # C4
        (cascade, unit(6, 0), 10),
    ],
)
@pytest.mark.parametrize("rtol", [1e-8, 1e-11])
def test_what_reaches_the_others_only_later(rates, start, end, rtol):
    t = np.linspace(0, end, 21)
    states, exact = solve(rates, t, start, rtol=rtol), by_scipy(rates, t, start)
    theirs = np.abs(
        by_scipy(rates, t, start, rtol=rtol, atol=rtol) - exact
    ).max()  # C2 is a little stiff: 40 times rtol
    assert np.abs(states - exact).max() < max(10 * rtol, theirs)


def test_a_force_all_of_whose_derivatives_are_zero_at_the_start():
    def rates(t, y):
        return y[1], (math.exp(-1 / t) if t > 0 else 0.0) - y[0]

    t = np.linspace(0, 10, 21)
    assert np.abs(solve(rates, t, [0.0, 0.0]) - by_scipy(rates, t, [0.0, 0.0])).max() < 1e-9


def test_an_ensemble_under_a_force_that_sets_in_late():
    """The square root is zero until t = 3."""

    def rates(t, y):
        return y[1], np.sqrt(np.abs(t - 3) + (t - 3)) - y[0]

    t, starts = np.linspace(0, 10, 5), np.zeros((20, 2))
    starts[10:, 0] = 1.0
    together = solve(rates, t, starts, rtol=1e-8, method="python")
    for start, result in zip(starts, together, strict=True):
        assert result == pytest.approx(solve(rates, t, start, rtol=1e-10, method="python"), abs=1e-6)
