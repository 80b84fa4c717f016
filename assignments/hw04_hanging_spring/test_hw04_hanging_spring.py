"""Visible tests of hw04: run them with `tam570 check hw04` (or plain pytest) as often as you like."""

from functools import partial

import hw04_hanging_spring as hw
import numpy as np
import pytest

SPRING = {"mass": 2.0, "stiffness": 8.0, "gravity": 10.0}  # kg, N/m, m/s^2; it can rest at z = -2.5 m
START = np.array([1.0, 2.0, -0.5]), np.array([3.0, 0.0, -1.0])  # m, m/s
PERIOD = np.pi  # s
numbers = partial(np.asarray, dtype=float)  # of a result, whatever kind of numbers or lists it came as


def test_two_forces_act_on_the_mass():
    forces = hw.free_body_diagram(np.array([1.0, 2.0, -3.0, 0.0, 0.0, 0.0]), mass=2.0, stiffness=5.0, gravity=10.0)
    assert len(forces) == 2
    for point, _ in forces:
        np.testing.assert_allclose(numbers(point), [1.0, 2.0, -3.0])
    assert all(direction is not None for _, direction in forces)
    arrows = [numbers(direction) for _, direction in forces]
    units = [arrow / np.linalg.norm(arrow) for arrow in arrows]
    assert max(unit @ [0, 0, -1] for unit in units) == pytest.approx(1.0)
    assert max(unit @ [-1, -2, 3] for unit in units) == pytest.approx(np.sqrt(14.0))


def test_at_the_origin_it_falls_freely():
    rates = numbers(hw.state_derivative(0.0, np.array([0, 0, 0, 1.0, 2.0, 3.0]), **SPRING))
    assert rates == pytest.approx([1, 2, 3, 0, 0, -10])


def test_the_spring_pulls_it_back_to_the_origin():
    rates = numbers(hw.state_derivative(0.0, np.array([1.0, -2.0, 0, 0, 0, 0]), **SPRING))
    assert rates[3:5] == pytest.approx([-4, 8])


def test_where_spring_and_weight_balance_nothing_happens():
    rates = numbers(hw.state_derivative(0.0, np.array([0, 0, -2.5, 0, 0, 0]), **SPRING))
    assert rates == pytest.approx(np.zeros(6))


def test_the_energy_has_three_terms():
    assert float(hw.energy(np.array([0, 0, 0, 0, 3.0, 0]), **SPRING)) == pytest.approx(9)
    assert float(hw.energy(np.array([0.5, 0, 0, 0, 0, 0]), **SPRING)) == pytest.approx(1)
    assert float(hw.energy(np.array([0, 0, -1.0, 0, 0, 0]), **SPRING)) == pytest.approx(4 - 20)


def test_after_a_period_it_is_back():
    start = np.concatenate(START)
    t = np.array([0.0, PERIOD])
    assert numbers(hw.solution(t, *START, **SPRING))[1] == pytest.approx(start)
    assert numbers(hw.simulate(t, *START, **SPRING))[1] == pytest.approx(start, abs=1e-4)


def test_simulation_and_solution_agree():
    t = np.array([0.0, 0.1, 0.7, 2.0])
    expected = numbers(hw.solution(t, *START, **SPRING))
    assert np.shape(expected) == (4, 6)
    np.testing.assert_allclose(numbers(hw.simulate(t, *START, **SPRING)), expected, atol=1e-4)


def test_the_simulation_keeps_its_energy_for_ten_periods():
    states = numbers(hw.simulate(np.linspace(0.0, 10 * PERIOD, 11), *START, **SPRING))
    energies = [float(hw.energy(state, **SPRING)) for state in states]
    np.testing.assert_allclose(energies, energies[0], atol=1e-4 * SPRING["stiffness"])


def test_the_simulation_begins_with_the_given_state():
    states = numbers(hw.simulate(np.array([5.0, 5.1, 5.2]), *START, **SPRING))
    assert states[0] == pytest.approx(np.concatenate(START))


def test_the_ellipse_of_a_start_at_its_end():
    """1 m beside the centre, moving across at 1 m/s: half a metre in the other direction."""
    centre, axes = hw.orbit(np.array([1.0, 0, -2.5]), np.array([0, 1.0, 0]), **SPRING)
    assert numbers(centre) == pytest.approx([0, 0, -2.5])
    assert np.abs(numbers(axes)) == pytest.approx(np.array([[1, 0, 0], [0, 0.5, 0]]))


@pytest.mark.parametrize("speed", [2.0, 0.02])
def test_the_ellipse_may_be_a_circle_or_thin(speed):
    _, axes = hw.orbit(np.array([1.0, 0, -2.5]), np.array([0, speed, 0]), **SPRING)
    larger, smaller = numbers(axes)
    assert np.linalg.norm(larger) == pytest.approx(1)
    assert np.linalg.norm(smaller) == pytest.approx(speed / 2)
    assert larger @ smaller == pytest.approx(0, abs=1e-12)


def test_let_go_at_rest_it_moves_on_a_line():
    _, axes = hw.orbit(np.array([3.0, 0, 1.5]), np.zeros(3), **SPRING)
    larger, smaller = numbers(axes)
    assert np.linalg.norm(larger) == pytest.approx(5)
    assert smaller == pytest.approx(np.zeros(3), abs=1e-6)


def test_up_and_down_it_moves_on_a_line_too():
    _, axes = hw.orbit(np.array([0, 0, -1.5]), np.array([0, 0, 2.0]), **SPRING)
    larger, smaller = numbers(axes)
    assert np.linalg.norm(larger) == pytest.approx(np.sqrt(2.0))
    assert smaller == pytest.approx(np.zeros(3), abs=1e-6)


def test_seen_from_the_x_axis_y_is_to_the_right_and_z_up():
    assert numbers(hw.project(np.array([[1.0, 2.0, 3.0]]), 0.0, 0.0)) == pytest.approx(np.array([[2, 3]]))


def test_seen_from_straight_above():
    seen = numbers(hw.project(np.array([[1.0, 2.0, 3.0]]), 0.0, np.pi / 2))
    assert seen == pytest.approx(np.array([[2, -1]]))


def test_the_picture_has_one_curve_and_names_on_its_axes():
    from matplotlib.figure import Figure

    from tam570.checking.drawings import curves, in_metres

    ax = Figure().add_subplot()
    t = np.linspace(0, PERIOD, 201)
    hw.plot_projection(ax, t, *START, 0.5, 0.3, **SPRING)
    assert len(curves(ax)) == 1
    seen = numbers(hw.project(numbers(hw.solution(t, *START, **SPRING))[:, :3], 0.5, 0.3))
    np.testing.assert_allclose(np.ptp(curves(ax)[0], axis=0), np.ptp(seen, axis=0), rtol=0.01)
    assert in_metres(ax.get_xlabel()) and in_metres(ax.get_ylabel())
