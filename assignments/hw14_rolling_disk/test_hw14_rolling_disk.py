"""Visible tests of hw14: run them with `tam570 check hw14` (or plain pytest) as often as you like."""

from functools import partial

import hw14_rolling_disk as hw
import numpy as np
import pytest

# mass 2 kg, radius .5 m: m a^2 is .5 kg m^2; a thin uniform disk
DISK = {"mass": 2.0, "radius": 0.5, "inertia": np.array([0.125, 0.25]), "gravity": 10.0}
STATE = np.array([0.3, -0.2, 0.5, 1.2, 0.7, 1.5, -0.4, 6.0])  # x, y, yaw, tilt, roll and the angles' rates
STRAIGHT = np.array([0.0, 0.0, 0.0, np.pi / 2, 0.0, 0.0, 0.0, 4.0])
LATER = np.linspace(0.0, 1.0, 5)  # s
numbers = partial(np.asarray, dtype=float)  # of a result, whatever kind of numbers or lists it came as


def test_forces_act_on_the_disk_at_two_points():
    state = np.array([1.0, 2.0, 0.0, np.pi / 2, 0.0, 0.0, 0.0, 3.0])
    forces = hw.free_body_diagram(state, mass=2.0, radius=0.5, gravity=10.0)
    points = {tuple(np.round(numbers(point), 9)) for point, _ in forces}
    np.testing.assert_allclose(sorted(points), [(1.0, 2.0, 0.0), (1.0, 2.0, 0.5)], atol=1e-8)
    ground = [direction for point, direction in forces if point[2] < 0.25]
    assert len(forces) - len(ground) == 1  # the weight
    assert len(ground) == 3 or len(ground) == 1 and ground[0] is None  # nothing is known of it


def test_straight_rolling_goes_on():
    rates = numbers(hw.euler_state_derivative(0.0, STRAIGHT, **DISK))
    np.testing.assert_allclose(rates, [-2.0, 0, 0, 0, 4.0, 0, 0, 0], atol=1e-12)


def test_a_disk_let_go_falls():
    tilted = np.array([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0])
    rates = numbers(hw.euler_state_derivative(0.0, tilted, **DISK))
    # about the contact line: (A + m a^2) tilt'' = -m g a cos(tilt)
    assert rates[6] == pytest.approx(-10.0 * np.cos(1.0) / 0.625)


def test_the_matrix_state():
    m = numbers(hw.matrix_state(STATE, radius=0.5))
    R = m[3:12].reshape(3, 3)
    np.testing.assert_allclose(R.T @ R, np.eye(3), atol=1e-12)
    assert R[2, 2] == pytest.approx(np.cos(1.2))  # the axle's z component
    assert m[2] == pytest.approx(0.5 * np.sin(1.2))  # the centre's height
    assert m[12:] @ R[:, 2] == pytest.approx(6.0 + 1.5 * np.cos(1.2))  # the total spin


def test_the_three_derivations_agree():
    m = numbers(hw.matrix_state(STATE, radius=0.5))
    by_matrix = numbers(hw.matrix_state_derivative(0.0, m, **DISK))
    by_multipliers = numbers(hw.multiplier_state_derivative(0.0, m, **DISK))
    np.testing.assert_allclose(by_multipliers, by_matrix, rtol=1e-9, atol=1e-9)
    # the angles' rates give the matrix state's by a small step along them
    rates, h = numbers(hw.euler_state_derivative(0.0, STATE, **DISK)), 1e-5
    after, before = (numbers(hw.matrix_state(STATE + k * h * rates, radius=0.5)) for k in (1, -1))
    np.testing.assert_allclose((after - before) / (2 * h), by_matrix, rtol=1e-5, atol=1e-5)


def test_the_point_at_the_contact_has_no_velocity():
    m = numbers(hw.matrix_state(STATE, radius=0.5))
    velocity = numbers(hw.matrix_state_derivative(0.0, m, **DISK))[:3]
    arm = np.array([STATE[0], STATE[1], 0.0]) - m[:3]
    np.testing.assert_allclose(velocity + np.cross(m[12:], arm), 0.0, atol=1e-12)


def test_the_motion_does_not_depend_on_the_times_between():
    every, few = (numbers(hw.simulate_euler(t, STATE, **DISK)) for t in (LATER, LATER[[0, -1]]))
    np.testing.assert_allclose(few[-1], every[-1], rtol=1e-5, atol=1e-5)


def test_both_simulations_give_one_motion():
    angles = numbers(hw.simulate_euler(LATER, STATE, **DISK))
    matrices = numbers(hw.simulate_matrix(LATER, numbers(hw.matrix_state(STATE, radius=0.5)), **DISK))
    expected = [numbers(hw.matrix_state(row, radius=0.5)) for row in angles]
    np.testing.assert_allclose(angles[0], STATE, atol=1e-12)
    np.testing.assert_allclose(matrices, expected, rtol=1e-5, atol=1e-5)


def test_the_energy_is_conserved():
    energies = [float(hw.energy(row, **DISK)) for row in numbers(hw.simulate_euler(LATER, STATE, **DISK))]
    assert float(hw.energy(STRAIGHT, **DISK)) == pytest.approx(0.5 * (0.5 + 0.25) * 16.0 + 10.0)
    np.testing.assert_allclose(energies, energies[0], rtol=1e-6)


def test_the_ground_carries_the_weight_of_straight_rolling():
    np.testing.assert_allclose(numbers(hw.contact_force(STRAIGHT, **DISK)), [0.0, 0.0, 20.0], atol=1e-12)


def test_a_steady_circle_is_steady():
    lean, R, a = 0.4, 3.0, 0.5
    precession = np.sqrt(4 * 10.0 * np.tan(lean) / (6 * R - 5 * a * np.sin(lean)))  # hw11, the thin disk
    spin = precession * (R - a * np.sin(lean)) / a
    assert float(hw.steady_residual(lean, precession, spin, **DISK)) == pytest.approx(0.0, abs=1e-9)


def test_the_thin_disk_is_stable_above_its_critical_speed():
    critical = float(hw.critical_speed(**DISK))
    assert critical == pytest.approx(np.sqrt(10.0 * 0.5 / 3))
    assert hw.growth_rate_squared(0.5 * critical, **DISK) > 0 > hw.growth_rate_squared(2 * critical, **DISK)


def test_the_drawing_is_on_the_rim():
    lines = numbers(hw.wireframe(STATE, radius=0.5, sides=12))
    centre = numbers(hw.matrix_state(STATE, radius=0.5))[:3]
    assert lines.shape == (14, 2, 3)
    np.testing.assert_allclose(np.linalg.norm(lines - centre, axis=2), 0.5, atol=1e-12)
    next_sides = np.roll(lines[:12], -1, axis=0)  # the polygon is closed, whichever end of a side you name first
    gaps = [np.abs(lines[:12, end] - next_sides[:, 1 - end]).max() for end in (0, 1)]
    assert min(gaps) < 1e-12


def test_the_diameters_roll_with_the_disk():
    diameters = []
    for state in (STATE, STATE + [0, 0, 0, 0, 0.6, 0, 0, 0]):
        start, end = numbers(hw.wireframe(state, radius=0.5, sides=12))[-1]
        R = numbers(hw.matrix_state(state, radius=0.5))[3:12].reshape(3, 3)
        diameters.append((end - start) @ R)
    assert abs(diameters[0] @ diameters[1]) == pytest.approx(1.0)  # m^2
