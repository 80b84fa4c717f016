"""`solve`: samples at any times, ensembles, constraints and rotations, and what an import loads."""

import math

import numpy as np
import pytest
from processes import imported_modules
from scipy.special import sici
from systems import EPS, PENDULUM, oscillator, pendulum

from tam570.integrate import solve, solve_rotation
from tam570.invariants import drift, rotation_defect, violation


def test_the_choice_of_times_changes_nothing():
    fine = np.linspace(0, 20, 4001)
    states = solve(pendulum, fine, [2.5, 0.0], parameters=PENDULUM, method="python")
    for stride in (1000, 800, 2000, 4000):
        coarse = solve(pendulum, fine[::stride], [2.5, 0.0], parameters=PENDULUM, method="python")
        assert (coarse == states[::stride]).all()


@pytest.mark.parametrize("method", ["gauss", "composition"])
def test_samples_off_the_steps_are_as_good_as_the_steps(method):
    t = np.sort(np.random.default_rng(570).uniform(0, 20, 200))
    states = solve(pendulum, t, [2.0, 0.0], parameters=PENDULUM, method=method, rtol=1e-13)
    assert drift(lambda state: state[1] ** 2 / 2 - 9.81 * math.cos(state[0]), states).max() < 1e-13  # of length 1 m


def test_the_first_row_is_the_start_bit_by_bit():
    start = np.array([0.1 + 0.2, -1 / 3])
    for method in ("auto", "gauss", "composition"):
        assert (solve(oscillator, [5.0, 5.1, 7.0], start, method=method)[0] == start).all()


def test_times_may_be_negative_far_off_and_uneven():
    t = -1e6 + np.array([0, 1e-9, 0.5, 0.5 + 2**-30, 6.0])
    states = solve(oscillator, t, [1.0, 0.0], rtol=1e-13)
    assert states[:, 0] == pytest.approx(np.cos(t - t[0]), abs=1e-12)


def test_an_ensemble_is_its_members():
    starts = np.random.default_rng(570).uniform(-1, 1, (40, 2))
    t = np.linspace(0, 5, 7)
    together = solve(pendulum, t, starts, parameters=PENDULUM, method="python")
    assert together.shape == (40, 7, 2)
    alone = [solve(pendulum, t, start, parameters=PENDULUM, method="python") for start in starts]
    assert together == pytest.approx(np.array(alone), abs=1e-11)  # a tenth of rtol: NumPy's sines round differently
    few = solve(lambda t, y: (y[1], -abs(float(y[0]))), t, starts[:3])
    assert few.shape == (3, 7, 2)


def test_importing_loads_numpy_at_most():
    loaded = imported_modules("import tam570.integrate")
    assert "numpy" in loaded
    assert not {"scipy", "llvmlite", "sympy", "matplotlib", "mpmath", "tam570.rotations"} & loaded


def test_projection_keeps_a_constraint_and_leaves_the_motion_right():
    def particle(t, state):
        x, y, u, v = state
        pull = (u * u + v * v - 9.81 * y) / (x * x + y * y)
        return u, v, -pull * x, -9.81 - pull * y

    def on_the_circle(state):
        x, y, u, v = state
        r = math.hypot(x, y)
        along = (x * v - y * u) / r
        return x / r, y / r, -along * y / r, along * x / r

    t = np.linspace(0, 100, 201)
    states = solve(particle, t, [1.0, 0.0, 0.0, 0.0], project=on_the_circle, rtol=1e-12)
    assert violation(lambda s: s[0] ** 2 + s[1] ** 2 - 1, states).max() < 10 * EPS
    assert violation(lambda s: s[0] * s[2] + s[1] * s[3], states).max() < 1e-14
    angle = solve(pendulum, t, [math.pi / 2, 0.0], parameters=PENDULUM, rtol=1e-12)[:, 0]
    assert states[:, 0] == pytest.approx(np.sin(angle), abs=1e-7)  # 2000 steps of 1e-12 add up in the phase
    free = solve(particle, t, [1.0, 0.0, 0.0, 0.0])
    assert violation(lambda s: s[0] ** 2 + s[1] ** 2 - 1, free).max() > 1e-9  # without the projection


def test_rotations_stay_rotations_and_angular_momentum_stays():
    def euler(t, omega, *, inertia):
        A, B, C = inertia
        p, q, r = omega
        return (B - C) / A * q * r, (C - A) / B * r * p, (A - B) / C * p * q

    t, inertia = np.linspace(0, 200, 101), (1.0, 2.0, 3.0)
    omegas, R = solve_rotation(euler, t, [0.1, 1.0, 0.2], np.eye(3), parameters={"inertia": inertia}, rtol=1e-12)
    assert rotation_defect(R).max() < 1e-14
    momentum = np.einsum("nij,nj->ni", R, inertia * omegas)
    assert np.abs(momentum - momentum[0]).max() < 1e-9


def test_a_rotation_passes_zero_over_zero():
    def acceleration(t, omega):
        return math.sin(t - 2) / (t - 2), 0.0, 0.0

    omegas, _ = solve_rotation(acceleration, [0.0, 3.0], [0.0, 0.0, 1.0], np.eye(3))
    assert omegas[-1, 0] == pytest.approx(sici(2)[0] + sici(1)[0], rel=1e-9)
