"""hw06's growth rates and critical speed, at 50 digits and by simulations of tiny yaw rates."""

import math
import sys

import mpmath
import numpy as np
import pytest
from cars import BODY, DIGITS, DRAW, LOCKED, car, free_and_dragging, hw, motion, only, usual, wheelbase

from tam570_grader.checks import assignments


def growth(speed, locked, c):
    """d(yaw acceleration)/d(yaw rate) at 0: moments about the free axle, differentiated with 50 digits."""
    free, dragging = (mpmath.mpf(x) for x in free_and_dragging(locked, c))
    m, arm, u = mpmath.mpf(c["mass"]), dragging - free, mpmath.mpf(speed)
    drag = mpmath.mpf(c["friction"]) * m * mpmath.mpf(c["gravity"]) * abs(free / arm)

    def yaw_acceleration(r):
        moment = -arm * drag * arm * r / mpmath.sqrt(u**2 + (arm * r) ** 2)
        return (moment + m * free * u * r) / (mpmath.mpf(c["yaw_inertia"]) + m * free**2)

    return mpmath.diff(yaw_acceleration, 0)


@LOCKED
def test_growth_rate_is_the_derivative_at_50_digits_and_a_difference_of_the_rates(locked):
    for _ in range(30):
        c = car()
        speed = float(10 ** DRAW.uniform(-1, 1) * usual(c))
        found = hw.yaw_growth_rate(speed, locked, **c)
        apart = [hw.yaw_growth_rate(speed, locked, **{**c, "friction": 0.0})]
        size = abs(apart[0]) + abs(found - apart[0])
        with mpmath.workdps(50):
            assert abs(found - growth(speed, locked, c)) <= DIGITS * size
        tiny = np.array([0, 0, 0, speed, 1e-6 * speed / wheelbase(c)])
        # the yaw acceleration is odd: a difference is off by the square of 1e-6
        difference = hw.state_derivative(0.0, tiny, locked, **c)[4] / tiny[4]
        assert abs(found - difference) <= 1e-11 * size


def test_the_critical_speed_is_where_the_growth_rate_changes_its_sign():
    for _ in range(30):
        c = car()
        road = only(c, "front", "rear", "friction", "gravity")
        critical = hw.critical_speed("rear", **road)
        assert critical**2 == pytest.approx(c["friction"] * c["gravity"] * wheelbase(c), rel=DIGITS)
        below, above = (hw.yaw_growth_rate(critical * (1 + e), "rear", **c) for e in (-1e-12, 1e-12))
        assert below < 0 < above
        assert hw.critical_speed("front", **road) == math.inf
        assert hw.yaw_growth_rate(1e6 * critical, "front", **c) < 0


def test_without_friction_the_rear_has_no_safe_speed():
    road = only(car(), "front", "rear", "gravity")
    assert hw.critical_speed("rear", friction=0.0, **road) == 0.0
    assert hw.critical_speed("front", friction=0.0, **road) == math.inf


@LOCKED
def test_small_yaw_rate_is_the_integral_of_the_growth_over_the_falling_speed(locked):
    """By mpmath's quadrature of growth/u' over ln u at 30 digits."""
    for _ in range(5):
        c = car()
        speed0 = float(DRAW.uniform(0.5, 3) * usual(c))
        speed = float(speed0 * DRAW.uniform(0.05, 1))
        found = hw.small_yaw_rate(speed, speed0, -0.3, locked, **c)
        with mpmath.workdps(30):
            free, dragging = (mpmath.mpf(x) for x in free_and_dragging(locked, c))
            slowing = mpmath.mpf(c["friction"]) * c["gravity"] * abs(free / (dragging - free))
            ends = [mpmath.log(mpmath.mpf(speed0)), mpmath.log(mpmath.mpf(speed))]

            def per_fold(s, c=c, slowing=slowing):
                return -growth(mpmath.exp(s), locked, c) * mpmath.exp(s) / slowing

            exponent = mpmath.quad(per_fold, ends)
            assert abs(found / (-0.3 * mpmath.exp(exponent)) - 1) <= DIGITS * (1 + abs(exponent))


@LOCKED
def test_small_yaw_rate_is_what_a_simulation_of_a_tiny_one_shows(locked):
    for _ in range(3):
        c = car(2.0)
        start = motion(c, 1.8, 1e-8)
        slowing = c["friction"] * hw.axle_load(locked, **only(c, "mass", "front", "rear", "gravity")) / c["mass"]
        t = np.linspace(0, 0.8 * start[3] / slowing, 9)
        yaw_rates = hw.simulate(t, start, locked, **c)[:, 4]
        expected = [hw.small_yaw_rate(start[3] - slowing * s, start[3], start[4], locked, **c) for s in t]
        # the square of the yaw rate, 1e-16, grows to what its largest value makes it
        tolerance = 1e-11 + 10 * (np.abs(expected).max() * wheelbase(c) / usual(c)) ** 2
        # the integrator's errors are relative to the largest yaw rate so far
        np.testing.assert_allclose(yaw_rates, expected, rtol=tolerance, atol=1e-14 * np.abs(expected).max())


@pytest.mark.parametrize(
    ("start", "car"),
    [
        (
            (-0.235199012408966, 3.9971478385340546, -7.281371780528036, 6.540810562747153, 0.0),
            (
                722.7571931032608,
                2406.600482543964,
                1.7475707023826028,
                1.1750117274590313,
                0.7390814865494137,
                14.003486415879372,
            ),
        ),
        (
            (0.012748897698458883, 0.4407580432097111, -4.3234204675900845, -1.9186076228570403, 0.0),
            (
                4.536725131190757,
                6.220548875868298,
                0.9535768532773177,
                0.7803127596966779,
                0.46519542639505007,
                19.183657117389565,
            ),
        ),
    ],
)
def test_the_checks_find_the_stop_of_a_car_that_does_not_turn(start, car):
    """Its yaw acceleration is zero or rounding, which ends no integration: two draws where it once did."""
    assignments.assignment(assignments.find(), "hw06_braking")
    known = dict(zip((*BODY, "friction", "gravity"), car, strict=True))
    time, end = sys.modules["_checks_hw06_braking.reference"].stopped(np.array(start), "front", known)
    slowing = known["friction"] * known["gravity"] * known["rear"] / wheelbase(known)
    assert time == pytest.approx(abs(start[3]) / slowing, rel=1e-5)
    way = math.copysign(start[3] ** 2 / (2 * slowing), start[3])
    place = start[0] + way * math.cos(start[2]), start[1] + way * math.sin(start[2])
    assert tuple(end[:3]) == pytest.approx((*place, start[2]), abs=1e-5 * abs(way))
