"""Visible tests of hw01: run them with `tam570 check hw01` (or plain pytest) as often as you like."""

import hw01_simple_pendulum as hw
import numpy as np
import pytest

PENDULUM = {"mass": 2.0, "length": 0.5, "gravity": 10.0}  # kg, m, m/s^2
ROD = {"length": 0.5, "gravity": 10.0}  # m, m/s^2
BALANCES = ("linear_momentum_balance", "angular_momentum_balance", "energy_balance", "power_balance", "virtual_work")


def test_two_forces_act_on_the_mass():
    forces = hw.free_body_diagram(0.7, -3.0, **PENDULUM)
    assert len(forces) == 2
    for point, _ in forces:
        np.testing.assert_allclose(np.asarray(point, float), [0.5 * np.sin(0.7), -0.5 * np.cos(0.7)])


def test_the_weight_is_down_and_the_force_of_the_rod_along_the_rod():
    directions = [direction for _, direction in hw.free_body_diagram(0.7, -3.0, **PENDULUM)]
    assert all(direction is not None for direction in directions)
    arrows = [np.asarray(direction, float) for direction in directions]
    units = [arrow / np.linalg.norm(arrow) for arrow in arrows]
    assert max(unit @ [0, -1] for unit in units) == pytest.approx(1.0)
    assert max(abs(unit @ [np.sin(0.7), -np.cos(0.7)]) for unit in units) == pytest.approx(1.0)


@pytest.mark.parametrize("name", BALANCES)
def test_held_out_horizontally_it_falls_with_g_over_l(name):
    alpha = getattr(hw, name)(np.pi / 2, 0.0, **PENDULUM)[0]
    assert float(alpha) == pytest.approx(-20.0)


@pytest.mark.parametrize("name", BALANCES)
def test_it_falls_towards_the_bottom_from_both_sides(name):
    positive, negative = (float(getattr(hw, name)(theta, 1.0, **PENDULUM)[0]) for theta in (0.3, -0.3))
    assert positive == pytest.approx(-negative)
    assert positive < 0


def test_at_rest_at_the_bottom_the_rod_carries_the_weight():
    assert float(hw.linear_momentum_balance(0.0, 0.0, **PENDULUM)[1]) == pytest.approx(20.0)


def test_the_moment_is_the_inertia_times_alpha():
    alpha, momentum, moment = map(float, hw.angular_momentum_balance(0.7, -3.0, **PENDULUM))
    assert moment == pytest.approx(2.0 * 0.5**2 * alpha)
    assert momentum == pytest.approx(2.0 * 0.5**2 * -3.0)


def test_the_energy_at_the_top_is_that_of_the_height():
    _, kinetic, potential = map(float, hw.energy_balance(np.pi, 0.0, **PENDULUM))
    assert (kinetic, potential) == pytest.approx((0.0, 2.0 * 10.0 * 2 * 0.5))


def test_gravity_has_no_power_at_the_bottom():
    assert float(hw.power_balance(0.0, 3.0, **PENDULUM)[1]) == pytest.approx(0.0)


def value(formula, **numbers):
    """The formula with these numbers for the symbols of these names."""
    symbols = {symbol: numbers[symbol.name] for symbol in formula.free_symbols}
    return complex(formula.subs(symbols).evalf())


NUMBERS = {"theta": 0.7, "omega": -3.0, "m": 2.0, "l": 0.5, "g": 10.0}


def test_the_lagrangian_is_kinetic_less_potential_energy():
    _, kinetic, potential = map(float, hw.energy_balance(0.7, -3.0, **PENDULUM))
    assert value(hw.lagrangian(), **NUMBERS) == pytest.approx(kinetic - potential)


def test_lagrange_equation_agrees_with_the_balances():
    alpha = float(hw.linear_momentum_balance(0.7, -3.0, **PENDULUM)[0])
    assert value(hw.lagrange_equation(), **NUMBERS) == pytest.approx(alpha)


def test_the_action_of_uniform_rotation_without_gravity():
    t = np.linspace(0.0, 2.0, 20001)
    action = float(hw.action(3.0 * t, t[1], mass=2.0, length=0.5, gravity=0.0))
    assert action == pytest.approx(2.0 * (0.5 * 3.0) ** 2 / 2 * 2.0)  # m v^2 / 2 for 2 s


def test_the_action_of_a_mass_that_is_held_still():
    potential = 2.0 * 10.0 * 0.5 * (1 - np.cos(1.2))
    action = float(hw.action(np.full(2001, 1.2), 0.001, mass=2.0, length=0.5, gravity=10.0))
    assert action == pytest.approx(-2.0 * potential)


def test_the_small_angle_solution_starts_as_given_and_swings():
    quarter = np.pi / 2 / np.sqrt(20.0)
    states = np.asarray(hw.small_angle_solution(np.array([0.0, quarter]), 0.1, 0.2, **ROD), float)
    np.testing.assert_allclose(states, [[0.1, 0.2], [0.2 / np.sqrt(20.0), -0.1 * np.sqrt(20.0)]], atol=1e-12)


def test_the_period_grows_with_the_amplitude():
    small = 2 * np.pi / np.sqrt(20.0)
    assert float(hw.period(0.01, **ROD)) == pytest.approx(small, rel=1e-5)
    assert float(hw.period(0.4, **ROD)) == pytest.approx(small * (1 + 0.4**2 / 16), rel=1e-3)
    assert hw.period(3.0, **ROD) > 2 * small


def test_the_simulated_pendulum_is_back_after_a_period():
    t = np.array([0.0, 0.3, float(hw.period(2.0, **ROD))])
    states = np.asarray(hw.simulate(t, 2.0, 0.0, **ROD), float)
    assert states.shape == (3, 2)
    np.testing.assert_allclose(states[0], [2.0, 0.0], atol=1e-12)
    np.testing.assert_allclose(states[2], [2.0, 0.0], atol=1e-4)


def test_the_simulated_pendulum_keeps_its_energy():
    states = np.asarray(hw.simulate(np.linspace(0.0, 10.0, 50), 2.0, 1.0, **ROD), float)
    energies = [float(sum(hw.energy_balance(theta, omega, **PENDULUM)[1:])) for theta, omega in states]
    np.testing.assert_allclose(energies, energies[0], rtol=1e-5)
