"""Accuracy of hw02's solution, by Lambert's W and the closed form at 60 digits and more (mpmath), differences of the
trajectory, the landing at right angles to the launch, the distance of fast paths from their limit.
"""

import math

import mpmath as mp
import numpy as np
import pytest

from tam570_grader import Case
from tam570_grader.checks import assignments

ballistics = assignments.solution("hw02_ballistics")

BALL = {"mass": 1.7, "gravity": 9.81}  # kg, m/s^2
SPEED, ANGLE = 30.0, 0.7  # m/s, rad
DRAGS = (0.0, 1e-300, 1e-16, 1e-12, 1e-8, 1e-4, 0.01, 0.3, 2.0, 50.0, 1e4, 1e8)  # kg/s
TIMES = np.array([0.0, 1e-9, 1e-4, 0.1, 1.0, 3.0, 30.0])  # s
CLOSED = 1e-13  # relative; a dozen roundings make 1e-15


def digits(drag):
    """Digits enough for the second differences of e^-s that the plain formulas make."""
    return mp.workdps(60 + 3 * max(0, round(-math.log10(drag))) if drag else 60)


def launch(drag):
    """c/m, vx, vy, g as exact numbers of many digits."""
    angle, speed = mp.mpf(ANGLE), mp.mpf(SPEED)
    k = mp.mpf(drag) / mp.mpf(BALL["mass"])
    return k, speed * mp.cos(angle), speed * mp.sin(angle), mp.mpf(BALL["gravity"])


def exact_terms(t, drag):
    """x, y, vx, vy, each as the terms that it is the sum of: the launch's and gravity's."""
    k, vx, vy, g = launch(drag)
    if k == 0:
        return (vx * t,), (vy * t, -g * t**2 / 2), (vx,), (vy, -g * t)
    fade = mp.exp(-k * t)
    far, fallen = (1 - fade) / k, -g * (k * t - 1 + fade) / k**2
    return (vx * far,), (vy * far, fallen), (vx * fade,), (vy * fade, -g * far)


@pytest.mark.parametrize("drag", DRAGS)
def test_trajectory_against_many_digits(drag):
    found = ballistics.trajectory(TIMES, SPEED, ANGLE, drag=drag, **BALL)
    with digits(drag):
        for t, row in zip(TIMES, found, strict=True):
            for value, terms in zip(row, exact_terms(mp.mpf(float(t)), drag), strict=True):
                # s = c t/m is rounded, which e^-s feels s-fold; below 1e-300 doubles have few digits
                allowed = CLOSED * (1 + drag / BALL["mass"] * t) * max(map(abs, terms)) + 1e-300
                assert abs(value - sum(terms)) <= allowed


def exact_flight_time(drag):
    """By Lambert's W."""
    k, _, vy, g = launch(drag)
    if k == 0:
        return 2 * vy / g
    a = 1 + k * vy / g
    return (a + mp.lambertw(-a * mp.exp(-a))) / k


@pytest.mark.parametrize("drag", DRAGS)
def test_flight_time_and_range_against_lamberts_w(drag):
    time = ballistics.flight_time(SPEED, ANGLE, drag=drag, **BALL)
    length = ballistics.horizontal_range(SPEED, ANGLE, drag=drag, **BALL)
    with digits(drag):
        exact = exact_flight_time(drag)
        (far,), *_ = exact_terms(exact, drag)
        assert abs(time / exact - 1) < CLOSED
        assert abs(length / far - 1) < CLOSED


@pytest.mark.parametrize("angle", [1e-9, 1e-3, math.pi / 2 - 1e-9, math.pi / 2])
def test_flat_and_steep_launches_land(angle):
    time = ballistics.flight_time(SPEED, angle, drag=0.4, **BALL)
    _, y, _, vy = ballistics.trajectory(np.array([0.0, time]), SPEED, angle, drag=0.4, **BALL)[1]
    assert time > 0
    assert abs(y) <= 1e-13 * SPEED * time * math.sin(angle)  # of the largest term
    assert vy < 0


@pytest.mark.parametrize("drag", [0.0, 1e-12, 0.3, 4.0])
@pytest.mark.parametrize("gravity", [0.0, 9.81])
def test_simulation_and_closed_form_agree_at_uneven_times(drag, gravity):
    known = {"mass": 1.7, "drag": drag, "gravity": gravity}
    t = np.array([3.0, 3.1, 4.7, 5.0, 9.0])
    simulated = ballistics.simulate(t, SPEED, ANGLE, **known)
    closed = ballistics.trajectory(t - 3.0, SPEED, ANGLE, **known)
    np.testing.assert_allclose(simulated, closed, rtol=0, atol=1e-11 * np.abs(closed).max())  # the rtol is 1e-13


def test_trajectory_obeys_newton():
    h = 1e-3
    t = 2.0 + h * np.arange(-3, 4)
    known = {"drag": 0.6, **BALL}
    states = ballistics.trajectory(t, SPEED, ANGLE, **known)
    slope = np.array([-1, 9, -45, 0, 45, -9, 1]) @ states / (60 * h)  # sixth order: 1e-18 k^7/140
    np.testing.assert_allclose(slope, ballistics.state_derivative(2.0, states[3], **known), rtol=1e-11)


@pytest.mark.parametrize("swiftness", [1e-9, 1e-3, 0.1, 1.0, 10.0, 1e3, 1e6, 1e12, 1e30])
def test_the_best_flight_lands_at_right_angles_to_its_launch(swiftness):
    """d(range)/d(angle) = -v0 . v1 / vy1 times the length of the launch's lever, by the implicit function theorem."""
    angle = ballistics.best_angle(swiftness, mass=1.0, drag=1.0, gravity=1.0)
    with mp.workdps(120):
        low, high = (cosine(mp.mpf(angle) * (1 + off), mp.mpf(swiftness)) for off in (-1e-12, 1e-12))
        assert low * high < 0


def cosine(angle, swiftness):
    """Of launch and landing velocity, times their lengths over the launch's squared; in units m = c = g = 1."""
    b = swiftness * mp.sin(angle)
    s = 1 + b + mp.lambertw(-(1 + b) * mp.exp(-1 - b))
    vx, vy = swiftness * mp.cos(angle) * mp.exp(-s), (b + 1) * mp.exp(-s) - 1
    return (mp.cos(angle) * vx + mp.sin(angle) * vy) / swiftness


def test_no_other_angle_goes_further():
    known = {"drag": 0.5, **BALL}
    best = ballistics.best_angle(SPEED, **known)
    ranges = [ballistics.horizontal_range(SPEED, a, **known) for a in np.linspace(0.01, math.pi / 2, 400)]
    assert max(ranges) <= ballistics.horizontal_range(SPEED, best, **known)


def test_without_drag_45_degrees_are_best():
    assert ballistics.best_angle(SPEED, drag=0.0, **BALL) == math.pi / 4
    assert ballistics.best_angle(SPEED, drag=1e-12, **BALL) == pytest.approx(math.pi / 4, abs=1e-12)


@pytest.mark.parametrize("angle", [0.1, 0.9, 1.5])
def test_fast_paths_approach_the_limit_shape(angle):
    """The largest distance falls as log(n)/n, n the speed in terminal speeds: fivefold or more in a decade."""
    gaps = [gap(angle, swiftness) for swiftness in (1e3, 1e4, 1e5, 1e6)]
    assert gaps[-1] < 1e-4
    assert all(wide > 5 * narrow for wide, narrow in zip(gaps, gaps[1:], strict=False))


def gap(angle, swiftness):
    """Largest distance of the path from the lines between the corners, and of a corner from the path, in m v/c."""
    known = {"mass": 1.0, "drag": 1.0, "gravity": 1.0}
    end = ballistics.flight_time(swiftness, angle, **known)
    t = np.concatenate([np.linspace(0, 40, 2000), np.linspace(40, end, 100)[1:]])
    path = ballistics.trajectory(t, swiftness, angle, **known)[:, :2] / swiftness
    corners = ballistics.limit_shape(angle)
    sides = [distance(path, a, b) for a, b in zip(corners, corners[1:], strict=False)]
    return max(np.min(sides, axis=0).max(), np.linalg.norm(path[:, None] - corners, axis=-1).min(axis=0).max())


def distance(points, a, b):
    """From each point to the segment from a to b."""
    along = np.clip((points - a) @ (b - a) / ((b - a) @ (b - a)), 0, 1)
    return np.linalg.norm(points - a - along[:, None] * (b - a), axis=1)


def test_the_size_of_a_flight_back_at_launch_height_is_that_of_its_path():
    """At the ends alone it has none: no simulation would be right to a part of that."""
    columns = assignments.assignment(assignments.find(), "hw02_ballistics").results["simulate"].columns
    time = ballistics.flight_time(SPEED, math.pi / 2, drag=0.3, **BALL)
    call = Case(np.array([2.0, 2.0 + time]), SPEED, math.pi / 2, drag=0.3, **BALL)
    ends = ballistics.trajectory(call.args[0] - 2.0, *call.args[1:], **call.kwargs)
    top = ballistics.trajectory(np.linspace(0.0, time, 101), *call.args[1:], **call.kwargs)[:, 1].max()
    assert [column.scale(call, ends) for column in columns] == pytest.approx([top, top, SPEED, SPEED], rel=0.05)


def test_the_plot_shows_both_paths_on_equal_scales():
    from matplotlib.figure import Figure

    axes = Figure().subplots()
    known = {"drag": 0.5, **BALL}
    ballistics.plot_comparison(axes, np.linspace(1.0, 5.0, 11), SPEED, ANGLE, **known)
    landing = ballistics.trajectory(np.array([0.0, 4.0]), SPEED, ANGLE, **known)[1, :2]
    numerical, closed = (line.get_xydata() for line in axes.lines)
    np.testing.assert_allclose(numerical, closed, atol=1e-9)
    np.testing.assert_allclose(closed[[0, -1]], [[0, 0], landing], atol=1e-9)
    assert axes.get_aspect() == 1
