"""Visible tests of hw10: run them with `tam570 check hw10` (or plain pytest) as often as you like."""

import math
from functools import partial

import hw10_free_rigid_body as hw
import numpy as np
import pytest

BODY = np.array([1.5, 2.0, 3.0])  # A, B, C, kg m^2
DISK = np.array([0.7, 0.7, 1.4])
OMEGA = np.array([0.6, -0.9, 0.8])  # rad/s
START = np.array([[0.0, -1.0, 0.0], [0.0, 0.0, -1.0], [1.0, 0.0, 0.0]])  # an attitude
T = np.array([1.0, 1.3, 2.0, 4.5, 5.0, 9.0])  # s
numbers = partial(np.asarray, dtype=float)  # of a result, whatever kind of numbers or lists it came as


def test_energy_and_angular_momentum_do_not_change():
    rate = numbers(hw.euler_equations(OMEGA, inertia=BODY))
    assert OMEGA @ (BODY * rate) == pytest.approx(0.0, abs=1e-14)
    assert (BODY * OMEGA) @ (BODY * rate) == pytest.approx(0.0, abs=1e-14)


def test_the_middle_axis_tips_over_the_right_way():
    # omega near (0, 1, 0) with a little of the third: A p' = (B - C) q r is negative
    rate = numbers(hw.euler_equations(np.array([0.0, 1.0, 0.1]), inertia=BODY))
    assert rate[0] == pytest.approx(-0.1 / 1.5)


def test_the_first_axis_of_the_body_moves_at_omega_cross_itself():
    rate = numbers(hw.attitude_rate(START, OMEGA))
    np.testing.assert_allclose(rate[:, 0], np.cross(START @ OMEGA, START[:, 0]), atol=1e-14)


def test_spin_about_the_body_z_axis_is_the_rate_of_phi():
    rates = numbers(hw.euler_rates_313(np.array([0.4, 1.1, -0.8]), np.array([0.0, 0.0, 2.0])))
    np.testing.assert_allclose(rates, [0, 0, 2], atol=1e-14)


def test_euler_rates_are_refused_where_theta_is_zero():
    with pytest.raises(ValueError):
        hw.euler_rates_313(np.array([0.4, 0.0, -0.8]), OMEGA)


def test_energy_is_half_of_omega_dot_h():
    H = numbers(hw.angular_momentum(np.eye(3), OMEGA, inertia=BODY))
    assert float(hw.energy(OMEGA, inertia=BODY)) == pytest.approx(0.5 * OMEGA @ H)


def test_the_motion_keeps_what_it_must():
    omegas, rotations = map(numbers, hw.simulate(T, START, OMEGA, inertia=BODY))
    np.testing.assert_allclose(omegas[0], OMEGA, atol=1e-12)
    np.testing.assert_allclose(rotations[0], START, atol=1e-12)
    for omega, R in zip(omegas, rotations, strict=True):
        np.testing.assert_allclose(R.T @ R, np.eye(3), atol=1e-6)
        np.testing.assert_allclose(R @ (BODY * omega), START @ (BODY * OMEGA), atol=1e-6)


def test_the_motion_obeys_euler_at_the_start():
    t = np.array([2.0, 2.001])
    omegas, rotations = map(numbers, hw.simulate(t, START, OMEGA, inertia=BODY))
    np.testing.assert_allclose(
        (omegas[1] - omegas[0]) / 1e-3, numbers(hw.euler_equations(OMEGA, inertia=BODY)), atol=1e-3
    )
    np.testing.assert_allclose((rotations[1] - rotations[0]) / 1e-3, numbers(hw.attitude_rate(START, OMEGA)), atol=2e-3)


def test_the_closed_form_is_the_motion_of_a_disk():
    omegas, _ = hw.simulate(T, START, OMEGA, inertia=DISK)
    np.testing.assert_allclose(numbers(hw.symmetric_solution(T, OMEGA, inertia=DISK)), numbers(omegas), atol=1e-5)


def test_a_disk_wobbles_about_twice_a_turn():
    assert float(hw.wobble_rate(np.array([0.001, 0.0, 1.0]), inertia=DISK)) == pytest.approx(2.0, rel=1e-5)


def test_the_middle_axis_alone_is_unstable():
    signs = [math.copysign(1, float(hw.growth_rate_squared(axis, 1.3, inertia=BODY))) for axis in (0, 1, 2)]
    assert signs == [-1, 1, -1]


@pytest.mark.parametrize("omega", [(0.3, 0.8, 1.0), (1.0, 0.8, 0.3)])
def test_omega_is_back_after_the_period(omega):
    period = float(hw.tumble_period(np.array(omega), inertia=BODY))
    t = np.array([0.0, 0.5 * period, period])
    omegas, _ = hw.simulate(t, START, np.array(omega), inertia=BODY)
    _, halfway, back = numbers(omegas)
    np.testing.assert_allclose(back, omega, atol=1e-5)
    assert np.abs(halfway - omega).max() > 0.1


def test_pure_spin_about_the_middle_axis_never_ends():
    assert float(hw.tumble_period(np.array([0.0, 1.0, 0.0]), inertia=np.array([3.0, 4.0, 6.0]))) == math.inf


def test_the_edges_turn_with_the_box():
    edges = numbers(hw.wireframe(START, size=np.array([1.0, 2.0, 3.0])))
    lengths = np.linalg.norm(edges[:, 1] - edges[:, 0], axis=1)
    np.testing.assert_allclose(np.sort(lengths), [1] * 4 + [2] * 4 + [3] * 4, atol=1e-12)
    np.testing.assert_allclose(np.abs(edges @ START), np.broadcast_to([0.5, 1.0, 1.5], (12, 2, 3)), atol=1e-12)
    middles = edges.mean(axis=1)
    assert len({tuple(middle) for middle in np.round(middles, 9) + 0.0}) == 12


def test_two_paths_are_drawn():
    from matplotlib.figure import Figure

    from tam570.checking.drawings import curves, in_metres

    ax = Figure().subplots()
    t, omega = np.linspace(1.0, 4.0, 201), np.array([0.1, 0.0, 2.0])
    hw.plot_rim_paths(ax, t, START, omega, inertia=DISK, radius=0.5)
    paths = curves(ax)
    assert len(paths) == 2
    _, rotations = hw.simulate(t, START, omega, inertia=DISK)
    seen = 0.5 * numbers(rotations)[:, 1:]  # the components y and z of the radii along the axes of the body
    sizes = sorted(np.ptp(path, axis=0).tolist() for path in paths)
    np.testing.assert_allclose(sizes, sorted(np.ptp(seen[..., k], axis=0).tolist() for k in (0, 1)), rtol=0.01)
    assert in_metres(ax.get_xlabel()) and in_metres(ax.get_ylabel())
