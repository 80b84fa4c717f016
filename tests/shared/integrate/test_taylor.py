"""Taylor's method: the series of every function, tolerances, zero coefficients, samples, ensembles."""

import math
from functools import partial

import numpy as np
import pytest

from tam570.integrate import solve
from tam570.invariants import drift

pytest.importorskip("llvmlite")

PLAIN = "sin cos tan asin acos atan sinh cosh tanh asinh atanh exp expm1 log log1p log2 log10 sqrt cbrt erf erfc"
INNER = {  # functions of u between 0.3 and 0.7
    **{name: getattr(math, name) for name in PLAIN.split(" ")},
    "acosh": lambda u: math.acosh(1 + u),
    "hypot": lambda u: math.hypot(u, 2.0 - u),
    "hypot with a number": lambda u: math.hypot(u, 0.5),
    "atan2": lambda u: math.atan2(u, u - 0.5),
    "power": lambda u: u**2.3,
    "power of a number": lambda u: 2.5**u,
    "power of a function": lambda u: (1 + u) ** (u * u),
    "half powers": lambda u: u**-1.5 + u**2.5,
    "quotients": lambda u: 1 / u + (1 - u) / (2 + u * u) - u / 3,
    "sine and cosine together": lambda u: math.sin(u) * math.cos(u) - math.cos(2 * u),
    "exp twice": lambda u: math.exp(u) + math.expm1(u),
}
QUARTER = math.pi / 2
SYMMETRIC = [(QUARTER, QUARTER), (QUARTER, -QUARTER), (math.pi, 0.0), (0.0, QUARTER), (-QUARTER, math.pi)]


@pytest.mark.parametrize("name", INNER)
def test_the_series_of_every_function(name):
    """For an argument that rises and falls, two methods agree that share only the values of the function."""
    inner = INNER[name]

    def rates(t, y):
        return inner(0.5 + 0.2 * math.cos(y[1])), 1.0 + 0.1 * y[0] * y[0] / (1 + y[0] * y[0])

    t = np.linspace(0, 12, 9)
    taylor, plain = (solve(rates, t, [0.1, 0.2], rtol=1e-13, method=m) for m in ("compiled", "python"))
    assert np.abs(taylor - plain).max() < 1e-11 * np.abs(plain).max()


@pytest.mark.parametrize("rtol", [1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13, 1e-15])
def test_a_tolerance_is_kept_at_every_order(rtol):
    t = np.linspace(0, 6, 200)
    states = solve(lambda t, y: (y[1], -y[0]), t, [1.0, 0.0], rtol=rtol, method="compiled")
    exact = np.stack([np.cos(t), -np.sin(t)], 1)
    assert np.abs(states - exact).max() < 10 * rtol + 2e-15  # samples inside the steps too


def double_pendulum(t, state):
    """Return the rates of two uniform bars of 1 m and 1 kg."""
    a, b, p, q = state
    c, s = math.cos(a - b) / 2, math.sin(a - b) / 2
    f = -s * q * q - 1.5 * 9.81 * math.sin(a)
    g = s * p * p - 0.5 * 9.81 * math.sin(b)
    d = 4 / 9 - c * c
    return p, q, (f / 3 - c * g) / d, (4 / 3 * g - c * f) / d


def energy(state):
    a, b, p, q = state
    kinetic = 2 / 3 * p * p + q * q / 6 + math.cos(a - b) * p * q / 2
    return kinetic - 9.81 * (1.5 * math.cos(a) + 0.5 * math.cos(b)) + 2 * 9.81


@pytest.mark.parametrize("angles", SYMMETRIC)
@pytest.mark.parametrize("rtol", [1e-4, 1e-8, 1e-12])
def test_from_rest_at_symmetric_angles_the_energy_stays(angles, rtol):
    states = solve(double_pendulum, np.linspace(0, 10, 101), (*angles, 0.0, 0.0), rtol=rtol, method="compiled")
    assert drift(energy, states).max() < 1e3 * rtol  # a few hundred steps; 0.17 if symmetry misleads them


@pytest.mark.parametrize("power", [1, 2, 4, 8, 16, 40])
@pytest.mark.parametrize("rtol", [1e-5, 1e-12])
def test_gaps_between_the_coefficients_are_no_accuracy(power, rtol):
    """y' = 1 + t^power has one coefficient far from the first; y' = 1 + y^power has every power-th."""
    plain = solve(lambda t, y: (1.0 + t**power,), [0, 2.0], [0.0], rtol=rtol, method="compiled")[-1, 0]
    assert plain == pytest.approx(2 + 2.0 ** (power + 1) / (power + 1), rel=10 * rtol)
    grow = partial(solve, lambda t, y: (1.0 + y[0] ** power,), [0.0, 0.5, 0.9], [0.0])
    curved, best = grow(rtol=rtol, method="compiled"), grow(rtol=1e-15, method="python")
    assert curved == pytest.approx(best, rel=100 * rtol)  # it becomes infinite at t = 1.6, 1.1, ...


def test_a_step_is_judged_at_its_end():
    """1 / (1 + t^8) has no coefficient between the first and the ninth: at a low order, no step seems too long."""
    end = solve(lambda t, y: (1 / (1 + t**8),), [0, 100.0], [1.0], rtol=1e-3, method="compiled")[-1, 0]
    assert end == pytest.approx(1 + math.pi / 8 / math.sin(math.pi / 8), rel=1e-2)  # 7 if it is not


def test_what_does_not_move_takes_no_steps_and_stays():
    states = solve(lambda t, y: (y[1], -math.sin(y[0])), [0, 1e6], [0.0, 0.0], method="compiled")
    assert (states == 0).all()


def test_motions_together_are_each_alone():
    rng = np.random.default_rng(570)
    starts, t = rng.uniform(-1, 1, (37, 4)), np.linspace(0, 3, 5)
    starts[:9, 2:], starts[3] = 0.0, 0.0  # at rest; in equilibrium
    together = solve(double_pendulum, t, starts, rtol=1e-12, method="compiled")
    alone = np.array([solve(double_pendulum, t, start, rtol=1e-12, method="compiled") for start in starts])
    assert np.abs(together - alone).max() < 1e-10
    assert (together[:, 0] == starts).all()
