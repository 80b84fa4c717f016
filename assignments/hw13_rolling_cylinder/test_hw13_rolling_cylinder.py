"""Visible tests of hw13: run them with `tam570 check hw13` (or plain pytest) as often as you like."""

import math

import hw13_rolling_cylinder as hw
import numpy as np
import pytest

BODY = {"mass": 2.0, "radius": 0.5, "offset": 0.2, "inertia": 0.15}  # kg, m, m, kg m^2
RAMP = {"slope": 0.3, "gravity": 9.8}  # rad, m/s^2
LEVEL = {"slope": 0.0, "gravity": 9.8}


def test_forces_act_on_the_cylinder_at_two_points():
    cylinder = {"mass": 2.0, "radius": 1.0, "offset": 0.5, "slope": 0.3, "gravity": 10.0}
    forces = hw.free_body_diagram(np.pi / 2, **cylinder)
    points = {tuple(np.round(np.asarray(point, float), 9)) for point, _ in forces}
    np.testing.assert_allclose(sorted(points), [(-0.5, 0.0), (0.0, -1.0)], atol=1e-8)
    contact = [np.asarray(direction, float) for point, direction in forces if point[1] < -0.5 and direction is not None]
    assert len(contact) in (0, 2)  # one force of which nothing is known, or two that are perpendicular
    assert not contact or contact[0] @ contact[1] == pytest.approx(0.0, abs=1e-9)


def test_a_centred_cylinder_rolls_as_in_the_textbook():
    centred = {**BODY, "offset": 0.0}
    expected = 9.8 * math.sin(0.3) / 0.5 / (1 + 0.15 / (2.0 * 0.5**2))
    assert float(hw.acceleration(0.7, 1.0, **centred, **RAMP)) == pytest.approx(expected)
    assert float(hw.naive_contact_acceleration(0.7, **centred, **RAMP)) == pytest.approx(expected)


def test_level_ground_has_an_equilibrium_with_G_below_the_centre():
    assert float(hw.acceleration(0.0, 0.0, **BODY, **LEVEL)) == pytest.approx(0.0, abs=1e-12)
    assert hw.acceleration(0.1, 0.0, **BODY, **LEVEL) < 0 < hw.acceleration(-0.1, 0.0, **BODY, **LEVEL)


def test_the_contact_inertia_is_least_with_G_next_to_the_contact():
    assert float(hw.contact_inertia(0.0, **BODY)) == pytest.approx(0.15 + 2.0 * 0.3**2)
    assert float(hw.contact_inertia(math.pi, **BODY)) == pytest.approx(0.15 + 2.0 * 0.7**2)


def test_at_rest_both_methods_agree_and_in_motion_they_do_not():
    naive = float(hw.naive_contact_acceleration(1.0, **BODY, **RAMP))
    assert float(hw.acceleration(1.0, 0.0, **BODY, **RAMP)) == pytest.approx(naive)
    assert float(hw.acceleration(1.0, 3.0, **BODY, **RAMP)) != pytest.approx(naive)


def test_the_missing_moment_closes_the_gap():
    phi, phi_dot = 1.0, -3.0
    inertia = float(hw.contact_inertia(phi, **BODY))
    sides = inertia * float(hw.acceleration(phi, phi_dot, **BODY, **RAMP))
    sides += float(hw.missing_moment(phi, phi_dot, mass=2.0, radius=0.5, offset=0.2))
    moment = inertia * float(hw.naive_contact_acceleration(phi, **BODY, **RAMP))
    assert sides == pytest.approx(moment)


def test_at_rest_on_level_ground_the_force_carries_the_weight():
    along, normal = map(float, hw.contact_force(0.0, 0.0, **BODY, **LEVEL))
    assert along == pytest.approx(0.0, abs=1e-12)
    assert normal == pytest.approx(2.0 * 9.8)


def test_the_energy_at_the_start():
    assert float(hw.energy(0.0, 0.0, **BODY, **LEVEL)) == pytest.approx(-2.0 * 9.8 * 0.2)
    assert float(hw.energy(math.pi, 0.0, **BODY, **LEVEL)) == pytest.approx(2.0 * 9.8 * 0.2)


def test_the_simulation_starts_where_it_is_told_and_keeps_the_energy():
    t = np.linspace(1.0, 4.0, 31)
    states = np.asarray(hw.simulate(t, 0.5, 1.0, **BODY, **RAMP), float)
    assert states.shape == (31, 2)
    np.testing.assert_allclose(states[0], [0.5, 1.0], atol=1e-12)
    energies = [float(hw.energy(*state, **BODY, **RAMP)) for state in states]
    np.testing.assert_allclose(energies, energies[0], rtol=0, atol=1e-5)
