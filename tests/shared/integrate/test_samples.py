"""States at the times asked for, which change nothing about the steps."""

import math

import numpy as np
import pytest
from systems import PENDULUM, oscillator, pendulum

from tam570.integrate import solve
from tam570.invariants import drift


def pendulum_energy(state):
    return state[1] ** 2 / 2 - 9.81 * math.cos(state[0])  # length 1 m


def clock(t, y):
    """y = exp(sin t): a stage at the wrong time shows, where the pendulum would hide it."""
    return (y[0] * math.cos(t),)


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
    assert drift(pendulum_energy, states).max() < 1e-13


def test_the_first_row_is_the_start_bit_by_bit():
    start = np.array([0.1 + 0.2, -1 / 3])
    for method in ("auto", "gauss", "composition"):
        assert (solve(oscillator, [5.0, 5.1, 7.0], start, method=method)[0] == start).all()


def test_times_may_be_negative_far_off_and_uneven():
    t = -1e6 + np.array([0, 1e-9, 0.5, 0.5 + 2**-30, 6.0])
    states = solve(oscillator, t, [1.0, 0.0], rtol=1e-13)
    assert states[:, 0] == pytest.approx(np.cos(t - t[0]), abs=1e-12)


def test_the_time_reaches_the_right_hand_side():
    t = np.linspace(-3, 4, 30)
    states = solve(clock, t, [math.exp(math.sin(-3))], rtol=1e-12)
    assert states[:, 0] == pytest.approx(np.exp(np.sin(t)), rel=1e-10)
