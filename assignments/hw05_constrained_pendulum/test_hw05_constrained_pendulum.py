"""Visible tests of hw05: run them with `tam570 check hw05` (or plain pytest) as often as you like."""

from functools import partial

import hw05_constrained_pendulum as hw
import numpy as np
import pytest

PENDULUM = {"mass": 3.0, "length": 2.0, "gravity": 10.0}  # kg, m, m/s^2
FREE = {**PENDULUM, "gravity": 0.0}
BOTTOM, RIGHT, TOP = (0.0, -2.0), (2.0, 0.0), (0.0, 2.0)  # m
numbers = partial(np.asarray, dtype=float)  # of a result, whatever kind of numbers or lists it came as


def state(position, velocity=(0.0, 0.0)):
    return np.array([*position, *velocity])


def test_two_forces_act_on_the_particle():
    forces = hw.free_body_diagram(np.array([3.0, -4.0, 4.0, 3.0]), mass=2.0, length=5.0, gravity=10.0)
    assert len(forces) == 2
    for point, _ in forces:
        np.testing.assert_allclose(numbers(point), [3.0, -4.0])


def test_at_rest_at_the_bottom_the_rod_carries_the_weight():
    assert numbers(hw.constraint_force(state(BOTTOM), **PENDULUM)) == pytest.approx([0, 30])


def test_at_rest_at_the_top_the_rod_pushes():
    assert numbers(hw.constraint_force(state(TOP), **PENDULUM)) == pytest.approx([0, 30])


def test_without_gravity_the_rod_turns_the_velocity():
    assert numbers(hw.constraint_force(state(RIGHT, (0, 4)), **FREE)) == pytest.approx([-24, 0])  # m v^2 / l


def test_held_out_horizontally_it_falls_freely():
    assert numbers(hw.acceleration(state(RIGHT), **PENDULUM)) == pytest.approx([0, -10])


def test_the_acceleration_keeps_it_on_the_circle():
    r, v = np.array([1.2, -1.6]), np.array([4.0, 3.0])
    assert r @ numbers(hw.acceleration(state(r, v), **PENDULUM)) == pytest.approx(-v @ v)


def test_a_state_off_the_circle_is_mended():
    mended = numbers(hw.consistent_state(np.array([3.0, 0, 5.0, 7.0]), length=2.0))
    assert mended == pytest.approx([2, 0, 0, 7])


def test_at_the_origin_no_point_is_the_nearest():
    with pytest.raises(ValueError):
        hw.consistent_state(np.array([0.0, 0, 1, 0]), length=2.0)


def test_the_energy_counts_from_the_height_of_the_hinge():
    assert float(hw.energy(state(BOTTOM, (4, 0)), mass=3.0, gravity=10.0)) == pytest.approx(24 - 60)


def test_without_gravity_it_goes_round_uniformly():
    t = np.linspace(0, np.pi, 5)  # s: at 4 m/s once around
    states = numbers(hw.simulate(t, state(BOTTOM, (4, 0)), **FREE))
    assert states[:, :2] == pytest.approx(np.array([BOTTOM, RIGHT, TOP, (-2, 0), BOTTOM]), abs=1e-4)


def test_it_swings_as_high_as_it_came_from():
    t = np.linspace(0, 5, 501)
    states = numbers(hw.simulate(t, state(RIGHT), **PENDULUM))
    assert states[0] == pytest.approx(state(RIGHT))
    assert states[:, 0].min() == pytest.approx(-2, abs=1e-2)
    assert states[:, 1].max() < 1e-4


def test_it_stays_on_the_circle_for_a_while():
    """For ten seconds; a hundred are asked for."""
    x, y, vx, vy = numbers(hw.simulate(np.linspace(0, 10, 20), state(RIGHT, (0, 1)), **PENDULUM)).T
    assert x**2 + y**2 == pytest.approx(np.full(20, 4.0), abs=4e-9)
    assert x * vx + y * vy == pytest.approx(np.zeros(20), abs=1e-8)


def test_the_rod_runs_from_the_hinge_to_the_particle():
    assert numbers(hw.wireframe(state(RIGHT), length=2.0)) == pytest.approx(np.array([[(0, 0), RIGHT]]))
