"""Visible tests of hw12: run them with `tam570 check hw12` (or plain pytest) as often as you like."""

import hw12_bead_on_wire as hw
import numpy as np
import pytest

WIRE = {"curvature": 0.8, "gravity": 10.0}  # 1/m, m/s^2
BEAD = {"mass": 2.0, **WIRE}  # kg
NUMBERS = {"x": 0.7, "v": -1.5, "m": 2.0, "c": 0.8, "g": 10.0}


def value(formula, **numbers):
    """The formula with these numbers for the symbols of these names."""
    symbols = {symbol: numbers[symbol.name] for symbol in formula.free_symbols}
    return complex(formula.subs(symbols).evalf())


def test_two_forces_act_on_the_bead():
    forces = hw.free_body_diagram(0.5, mass=2.0, curvature=3.0, gravity=10.0)
    assert len(forces) == 2
    for point, _ in forces:
        np.testing.assert_allclose(np.asarray(point, float), [0.5, 0.75])
    assert all(direction is not None for _, direction in forces)
    arrows = [np.asarray(direction, float) for _, direction in forces]
    units = [arrow / np.linalg.norm(arrow) for arrow in arrows]
    assert max(unit @ [0, -1] for unit in units) == pytest.approx(1.0)
    assert max(abs(unit @ [-3, 1]) for unit in units) == pytest.approx(np.sqrt(10.0))  # the wire rises by 3 to 1


def test_the_lagrangian_at_the_bottom_is_that_of_a_flat_wire():
    moving, at_rest = (value(hw.lagrangian(), **{**NUMBERS, "x": 0.0, "v": v}) for v in (3.0, 0.0))
    assert moving - at_rest == pytest.approx(9.0)


def test_lagrange_and_newton_agree():
    newton = float(hw.acceleration_newton(0.7, -1.5, **WIRE))
    assert value(hw.lagrange_equation(), **NUMBERS) == pytest.approx(newton)


def test_near_the_bottom_it_is_an_oscillator():
    assert float(hw.acceleration_newton(1e-6, 0.0, **WIRE)) == pytest.approx(-2 * 10.0 * 0.8 * 1e-6)


def test_the_bead_is_pushed_towards_the_bottom_from_both_sides():
    positive, negative = (float(hw.acceleration_newton(x, 1.5, **WIRE)) for x in (0.7, -0.7))
    assert positive < 0 < negative
    assert positive == pytest.approx(-negative)


def test_passing_the_bottom_the_wire_carries_and_turns_the_bead():
    carried = 2.0 * (10.0 + 2 * 0.8 * 3.0**2)  # N
    force = np.asarray(hw.constraint_force(0.0, 3.0, **BEAD), float)
    np.testing.assert_allclose(force, [0.0, carried], atol=1e-12)


def test_the_force_is_normal_to_the_wire():
    force = np.asarray(hw.constraint_force(0.7, -1.5, **BEAD), float)
    assert force @ [1.0, 2 * 0.8 * 0.7] == pytest.approx(0.0, abs=1e-12)


def test_the_energy_at_rest_is_that_of_the_height():
    assert float(hw.energy(0.5, 0.0, **BEAD)) == pytest.approx(2.0 * 10.0 * 0.8 * 0.5**2)


def test_small_amplitudes_have_the_period_of_the_oscillator():
    assert float(hw.period(1e-4, **WIRE)) == pytest.approx(2 * np.pi / np.sqrt(2 * 10.0 * 0.8), rel=1e-6)


def test_the_simulated_bead_is_back_after_a_period():
    t = np.array([0.0, 0.3, float(hw.period(1.5, **WIRE))])
    states = np.asarray(hw.simulate(t, 1.5, 0.0, **WIRE), float)
    assert states.shape == (3, 2)
    np.testing.assert_allclose(states[0], [1.5, 0.0], atol=1e-12)
    np.testing.assert_allclose(states[2], [1.5, 0.0], atol=1e-4)


def test_the_simulated_bead_keeps_its_energy():
    states = np.asarray(hw.simulate(np.linspace(0.0, 10.0, 50), 1.5, 1.0, **WIRE), float)
    energies = [float(hw.energy(x, v, **BEAD)) for x, v in states]
    np.testing.assert_allclose(energies, energies[0], rtol=1e-5)


def test_without_gravity_the_speed_along_the_wire_stays():
    x, v = np.asarray(hw.simulate(np.linspace(0.0, 2.0, 9), -0.7, 1.5, curvature=0.8, gravity=0.0), float).T
    speeds = v * np.sqrt(1 + (2 * 0.8 * x) ** 2)
    np.testing.assert_allclose(speeds, speeds[0], rtol=1e-5)
