"""hw02's solution against many digits: closed form, Lambert's W, the best flight, the limit shape of fast paths."""

import math

import mpmath as mp
import numpy as np
import pytest

from tam570_grader import Case
from tam570_grader.checks import assignments

ballistics = assignments.solution("hw02_ballistics")

BALL = {"mass": 1.7, "gravity": 9.81}  # kg, m/s^2
UNIT = {"mass": 1.0, "drag": 1.0, "gravity": 1.0}
SPEED, ANGLE = 30.0, 0.7  # m/s, rad
DRAGS = (0.0, 1e-300, 1e-16, 1e-12, 1e-8, 1e-4, 0.01, 0.3, 2.0, 50.0, 1e4, 1e8)  # kg/s
TIMES = np.array([0.0, 1e-9, 1e-4, 0.1, 1.0, 3.0, 30.0])  # s
CLOSED = 1e-13  # relative; a dozen roundings make 1e-15


def terms_of_a_state(t, drag):
    """x, y, vx, vy, each as the terms that it is the sum of: the launch's and gravity's."""
    angle, speed, g, k = mp.mpf(ANGLE), mp.mpf(SPEED), mp.mpf(BALL["gravity"]), mp.mpf(drag) / mp.mpf(BALL["mass"])
    vx, vy = speed * mp.cos(angle), speed * mp.sin(angle)
    if t is None:  # of the landing, by Lambert's W
        a = 1 + k * vy / g
        t = (a + mp.lambertw(-a * mp.exp(-a))) / k if k else 2 * vy / g
        return t, terms_of_a_state(t, drag)
    if k == 0:
        return (vx * t,), (vy * t, -g * t**2 / 2), (vx,), (vy, -g * t)
    fade = mp.exp(-k * t)
    far, fallen = (1 - fade) / k, -g * (k * t - 1 + fade) / k**2
    return (vx * far,), (vy * far, fallen), (vx * fade,), (vy * fade, -g * far)


@pytest.mark.parametrize("drag", DRAGS)
def test_trajectory_flight_time_and_range_against_many_digits(drag):
    """With digits enough for the second differences of e^-s that the plain formulas make."""
    with mp.workdps(60 + 3 * max(0, round(-math.log10(drag))) if drag else 60):
        for t, row in zip(TIMES, ballistics.trajectory(TIMES, SPEED, ANGLE, drag=drag, **BALL), strict=True):
            for value, summands in zip(row, terms_of_a_state(mp.mpf(float(t)), drag), strict=True):
                # s = c t/m is rounded, which e^-s feels s-fold; below 1e-300 doubles have few digits
                allowed = CLOSED * (1 + drag / BALL["mass"] * t) * max(map(abs, summands)) + 1e-300
                assert abs(value - sum(summands)) <= allowed
        landing, ((far,), *_) = terms_of_a_state(None, drag)
        assert abs(ballistics.flight_time(SPEED, ANGLE, drag=drag, **BALL) / landing - 1) < CLOSED
        assert abs(ballistics.horizontal_range(SPEED, ANGLE, drag=drag, **BALL) / far - 1) < CLOSED


@pytest.mark.parametrize("swiftness", [1e-9, 1e-3, 0.1, 1.0, 10.0, 1e3, 1e6, 1e12, 1e30])
def test_the_best_flight_lands_at_right_angles_to_its_launch(swiftness):
    """d(range)/d(angle) = -v0 . v1 / vy1 times the length of the launch's lever, by the implicit function theorem."""

    def cosine(angle, swiftness):
        """Of launch and landing velocity, times their lengths over the launch's squared; in units m = c = g = 1."""
        b = swiftness * mp.sin(angle)
        s = 1 + b + mp.lambertw(-(1 + b) * mp.exp(-1 - b))
        vx, vy = swiftness * mp.cos(angle) * mp.exp(-s), (b + 1) * mp.exp(-s) - 1
        return (mp.cos(angle) * vx + mp.sin(angle) * vy) / swiftness

    angle = ballistics.best_angle(swiftness, **UNIT)
    with mp.workdps(120):
        low, high = (cosine(mp.mpf(angle) * (1 + off), mp.mpf(swiftness)) for off in (-1e-12, 1e-12))
        assert low * high < 0


def test_the_size_of_a_flight_back_at_launch_height_is_that_of_its_path():
    """At the ends alone it has none: no simulation would be right to a part of that."""
    columns = assignments.assignment(assignments.find(), "hw02_ballistics").results["simulate"].columns
    time = ballistics.flight_time(SPEED, math.pi / 2, drag=0.3, **BALL)
    call = Case(np.array([2.0, 2.0 + time]), SPEED, math.pi / 2, drag=0.3, **BALL)
    ends = ballistics.trajectory(call.args[0] - 2.0, *call.args[1:], **call.kwargs)
    top = ballistics.trajectory(np.linspace(0.0, time, 101), *call.args[1:], **call.kwargs)[:, 1].max()
    assert [column.scale(call, ends) for column in columns] == pytest.approx([top, top, SPEED, SPEED], rel=0.05)
