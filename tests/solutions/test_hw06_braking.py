"""hw06's solution against fifty digits: Jourdain's principle; the stop of a straight car."""

import math

import mpmath
import numpy as np
import pytest

from tam570_grader.checks import assignments

hw = assignments.solution("hw06_braking")

DRAW = np.random.default_rng(6)
DIGITS = 1e-13  # relative to the largest term; closed forms of a dozen operations in doubles
LOCKED = pytest.mark.parametrize("locked", ["front", "rear"])


def car(size=6.0, **fixed):
    """Masses and lengths over `size` decades to both sides, any place of G and any inertia that a car may have."""
    mass, length = (float(x) for x in 10 ** DRAW.uniform(-size, size, 2))
    front, rear = (float(length * x) for x in DRAW.uniform(0.2, 2, 2))
    lengths = {"front": front, "rear": rear}
    road = {"friction": float(DRAW.uniform(0.1, 1)), "gravity": float(10 ** DRAW.uniform(-1, 2))}
    return {"mass": mass, "yaw_inertia": float(mass * front * rear * DRAW.uniform(0.2, 3)), **lengths, **road, **fixed}


def only(car, *names):
    return {name: car[name] for name in names}


def slowing(locked, car):
    """The deceleration of a car that does not turn."""
    return car["friction"] * hw.axle_load(locked, **only(car, "mass", "front", "rear", "gravity")) / car["mass"]


def wheelbase(car):
    return car["front"] + car["rear"]


def usual(car):
    """Size of speeds: friction stops it within about a wheelbase."""
    return math.sqrt(max(car["friction"], 0.1) * max(car["gravity"], 0.1) * wheelbase(car))


def motion(car, speed=None, yaw=None):
    """A state of any place and heading; speed and yaw rate in their usual sizes."""
    speed, yaw = (DRAW.normal() if value is None else value for value in (speed, yaw))
    length, heading = wheelbase(car), DRAW.uniform(-9, 9)
    return np.array([*DRAW.normal(size=2) * length, heading, speed * usual(car), yaw * usual(car) / length])


def free_and_dragging(locked, car):
    return (-car["rear"], car["front"]) if locked == "front" else (car["front"], -car["rear"])


def scales(state, car):
    """Of place, heading, speed and yaw rate."""
    v = abs(state[3]) + abs(state[4]) * wheelbase(car)
    way = v * v / (car["friction"] * car["gravity"]) if car["friction"] * car["gravity"] else wheelbase(car)
    return np.array([way, way, 1.0, v, v / wheelbase(car)])


def jourdain(rates, state, locked, car):
    """Residuals of the principle of virtual power at 50 digits, for the two motions that the free axle allows.

    G's acceleration is the derivative of its velocity along a motion with these rates; no axes turn, no side force
    occurs. Returns the residuals of a virtual speed and of a virtual yaw rate, and the sizes of their terms.
    """
    m, inertia = mpmath.mpf(car["mass"]), mpmath.mpf(car["yaw_inertia"])
    free, dragging = (mpmath.mpf(x) for x in free_and_dragging(locked, car))
    heading, u, r = (mpmath.mpf(float(x)) for x in state[2:])
    du, dr = (mpmath.mpf(float(x)) for x in rates[3:])

    def of_G(t):
        return (u + du * t - 1j * free * (r + dr * t)) * mpmath.expj(heading + r * t + dr * t * t / 2)

    acceleration = mpmath.diff(of_G, 0) / mpmath.expj(heading)
    arm = dragging - free
    sliding = u + 1j * arm * r
    load = m * mpmath.mpf(car["gravity"]) * abs(free) / abs(arm)
    force = -mpmath.mpf(car["friction"]) * load * sliding / abs(sliding) if sliding else mpmath.mpc(0)
    along = m * acceleration.real - force.real
    about = -free * m * acceleration.imag + inertia * dr - arm * force.imag
    size = m * (abs(du) + abs(free) * r * r) + abs(force)
    turning = abs(arm * force) + m * abs(free * u * r) + abs(inertia * dr)
    return along, about, size, turning


@LOCKED
@pytest.mark.parametrize("fixed", [{}, {"friction": 0.0}, {"gravity": 0.0}])
def test_the_rates_satisfy_jourdains_principle(locked, fixed):
    """And the free axle moves forward at the speed, without slipping sideways."""
    for _ in range(40):
        c = car(**fixed)
        state = motion(c)
        rates = hw.state_derivative(0.0, state, locked, **c)
        along, about, size, turning = jourdain(rates, state, locked, c)
        assert abs(along) <= DIGITS * size
        assert abs(about) <= DIGITS * turning
        forward = np.array([math.cos(state[2]), math.sin(state[2])])
        of_free = rates[:2] + free_and_dragging(locked, c)[0] * state[4] * np.array([-forward[1], forward[0]])
        scale = np.abs(rates[:2]).max() + wheelbase(c) * abs(state[4])
        np.testing.assert_allclose(of_free, state[3] * forward, rtol=0, atol=DIGITS * scale)


@LOCKED
@pytest.mark.parametrize("sign", [1, -1])
def test_a_straight_car_stops_as_in_the_textbook(locked, sign):
    c = car()
    start = motion(c, sign * 1.3, 0.0)
    stop = abs(start[3]) / slowing(locked, c)
    t = stop * np.array([0.0, 0.3, 0.999999, 1.0 + 1e-12, 1.5, 1000.0])
    remaining = np.clip(1 - t / stop, 0, 1)
    way = start[3] * stop / 2 * (1 - remaining**2)
    ahead = np.array([math.cos(start[2]), math.sin(start[2])])
    expected = np.column_stack([start[:2] + np.outer(way, ahead), np.full(6, start[2]), start[3] * remaining, 0 * t])
    result = hw.simulate(t - 7 * stop, start, locked, **c)
    np.testing.assert_allclose(result / scales(start, c), expected / scales(start, c), rtol=0, atol=1e-12)
    assert not result[4:, 3:].any() and not result[:, 4].any()  # never turns, at rest not even by a rounding
