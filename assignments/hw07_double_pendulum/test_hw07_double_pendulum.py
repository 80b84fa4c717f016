"""Visible tests of hw07: run them with `tam570 check hw07` (or plain pytest) as often as you like."""

import math
from functools import partial

import hw07_double_pendulum as hw
import numpy as np
import pytest
from matplotlib.figure import Figure

from tam570.checking.drawings import curves, in_metres

BARS = {"masses": np.array([2.0, 1.5]), "lengths": np.array([1.0, 0.8])}  # kg, m
PENDULUM = {**BARS, "gravity": 9.81}  # m/s^2
THETA, OMEGA = np.array([0.7, -0.4]), np.array([1.5, -2.0])  # rad, rad/s
LEVEL = {"masses": np.array([1.0, 2.0]), "lengths": np.array([1.0, 2.0]), "gravity": 10.0}
DOWN, STILL = np.zeros(2), np.zeros(2)
numbers = partial(np.asarray, dtype=float)  # of a result, whatever kind of numbers or lists it came as


@pytest.mark.parametrize(("bar", "places"), [(1, [(0.0, 0.0), (0.5, 0.0), (1.0, 0.0)]), (2, [(1.0, -1.0), (1.0, 0.0)])])
def test_the_forces_on_a_bar_act_at_so_many_points(bar, places):
    forces = hw.free_body_diagram(bar, np.array([np.pi / 2, 0.0]), **LEVEL)
    points = sorted({tuple(np.round(numbers(point), 9)) for point, _ in forces})
    assert len(points) == len(places)
    np.testing.assert_allclose(points, places, atol=1e-8)
    assert len(forces) > len(points) or sum(direction is None for _, direction in forces) == len(points) - 1  # hinges


def test_there_is_no_third_bar():
    with pytest.raises(ValueError):
        hw.free_body_diagram(3, np.array([np.pi / 2, 0.0]), **LEVEL)


def test_the_mass_matrix_is_that_of_two_independent_equations():
    M = numbers(hw.mass_matrix(THETA, **BARS))
    assert M.shape == (2, 2)
    assert abs(np.linalg.det(M)) > 1e-6 * np.prod(np.linalg.norm(M, axis=1))


EQUAL = {"masses": np.ones(2), "lengths": np.ones(2)}  # kg, m
RIGHT_ANGLE = np.array([np.pi / 2, 0.0])


def by_lagrange(values):
    """Your two equations combined into those of Lagrange, whose [M] of equal bars at a right angle is known."""
    combined = numbers(hw.mass_matrix(RIGHT_ANGLE, **EQUAL)) @ np.diag([3 / 4, 3])
    return np.linalg.solve(combined, numbers(values))


def test_the_velocity_terms_belong_to_the_mass_matrix():
    forces = hw.velocity_terms(RIGHT_ANGLE, np.array([3.0, 2.0]), **EQUAL)
    np.testing.assert_allclose(by_lagrange(forces), [2.0, -4.5], atol=1e-9)


def test_the_gravity_terms_belong_to_the_mass_matrix():
    forces = hw.gravity_terms(RIGHT_ANGLE, gravity=10.0, **EQUAL)
    np.testing.assert_allclose(by_lagrange(forces), [15.0, 0.0], atol=1e-9)


def test_bars_in_line_have_no_velocity_terms():
    np.testing.assert_allclose(numbers(hw.velocity_terms(np.array([0.3, 0.3]), OMEGA, **BARS)), 0, atol=1e-12)


def test_hanging_straight_down_gravity_turns_nothing():
    np.testing.assert_allclose(numbers(hw.gravity_terms(DOWN, **PENDULUM)), 0, atol=1e-12)


def test_hanging_straight_down_nothing_accelerates():
    np.testing.assert_allclose(numbers(hw.angular_acceleration(DOWN, STILL, **PENDULUM)), 0, atol=1e-12)


def test_the_accelerations_obey_the_equations_of_motion():
    alpha = numbers(hw.angular_acceleration(THETA, OMEGA, **PENDULUM))
    f, g = numbers(hw.velocity_terms(THETA, OMEGA, **BARS)), numbers(hw.gravity_terms(THETA, **PENDULUM))
    np.testing.assert_allclose(numbers(hw.mass_matrix(THETA, **BARS)) @ alpha + f + g, 0, atol=1e-9)


def test_on_the_fly_gives_the_same_accelerations():
    alpha, _ = hw.on_the_fly(THETA, OMEGA, **PENDULUM)
    np.testing.assert_allclose(numbers(alpha), numbers(hw.angular_acceleration(THETA, OMEGA, **PENDULUM)), rtol=1e-9)


def test_the_ceiling_carries_both_bars_at_rest():
    _, forces = hw.on_the_fly(DOWN, STILL, **PENDULUM)
    np.testing.assert_allclose(numbers(forces), [[0, 3.5 * 9.81], [0, 1.5 * 9.81]], atol=1e-9)


def test_the_energy_of_bars_at_rest_is_potential():
    assert float(hw.energy(np.full(2, math.pi / 2), STILL, **PENDULUM)) == pytest.approx(0, abs=1e-12)
    assert float(hw.energy(DOWN, STILL, **PENDULUM)) == pytest.approx(-9.81 * (2.0 * 0.5 + 1.5 * 1.4))


def test_bars_in_line_that_turn_as_one_have_the_angular_momentum_of_one_bar():
    long_bar = {"masses": np.ones(2), "lengths": np.ones(2)}  # a bar of mass 2 and length 2: m l^2/3 = 8/3
    assert float(hw.angular_momentum(np.full(2, 0.4), np.full(2, 3.0), **long_bar)) == pytest.approx(3.0 * 8 / 3)


def test_the_energy_stays():
    t = np.linspace(0.0, 3.0, 31)
    states = numbers(hw.simulate(t, THETA, OMEGA, **PENDULUM))
    np.testing.assert_allclose(states[0], [*THETA, *OMEGA], atol=1e-12)
    energies = [float(hw.energy(state[:2], state[2:], **PENDULUM)) for state in states]
    np.testing.assert_allclose(energies, energies[0], atol=1e-4)
    assert np.ptp(states[:, 0]) > 0.1


def test_equal_bars_have_the_frequencies_of_the_book():
    equal = {"masses": np.ones(2), "lengths": np.ones(2), "gravity": 1.0}
    frequencies = numbers(hw.small_oscillation_frequencies(**equal))
    np.testing.assert_allclose(frequencies**2, [3 - 6 / math.sqrt(7), 3 + 6 / math.sqrt(7)], atol=1e-12)


def test_the_bars_hang_below_the_ceiling():
    bars = numbers(hw.wireframe(DOWN, lengths=BARS["lengths"]))
    np.testing.assert_allclose(bars, [[[0, 0], [0, -1]], [[0, -1], [0, -1.8]]], atol=1e-12)


def test_the_tip_path_is_drawn():
    axes = Figure().subplots()
    t = np.linspace(0.0, 1.0, 201)
    hw.plot_tip_path(axes, t, THETA, OMEGA, **PENDULUM)
    assert len(curves(axes)) == 1
    states = numbers(hw.simulate(t, THETA, OMEGA, **PENDULUM))
    tips = np.array([numbers(hw.wireframe(state[:2], lengths=BARS["lengths"]))[1, 1] for state in states])
    np.testing.assert_allclose(np.ptp(curves(axes)[0], axis=0), np.ptp(tips, axis=0), rtol=0.01)
    assert in_metres(axes.get_xlabel()) and in_metres(axes.get_ylabel())
