"""Cars that brake, drawn over many decades, and the scales of their motion."""

import math

import numpy as np
import pytest

from tam570_grader.checks import assignments

hw = assignments.solution("hw06_braking")

DRAW = np.random.default_rng(6)
DIGITS = 1e-13  # relative to the largest term; closed forms of a dozen operations in doubles
LOCKED = pytest.mark.parametrize("locked", ["front", "rear"])
BODY = ("mass", "yaw_inertia", "front", "rear")


def car(size=6.0, **fixed):
    """Masses and lengths over `size` decades to both sides, any place of G and any inertia that a car may have."""
    mass, length = (float(x) for x in 10 ** DRAW.uniform(-size, size, 2))
    front, rear = (float(length * x) for x in DRAW.uniform(0.2, 2, 2))
    drawn = {
        "mass": mass,
        "yaw_inertia": float(mass * front * rear * DRAW.uniform(0.2, 3)),
        "front": front,
        "rear": rear,
        "friction": float(DRAW.uniform(0.1, 1)),
        "gravity": float(10 ** DRAW.uniform(-1, 2)),
    }
    return {**drawn, **fixed}


def only(car, *names):
    return {name: car[name] for name in names}


def body(car):
    return only(car, *BODY)


def wheelbase(car):
    return car["front"] + car["rear"]


def usual(car):
    """Size of speeds: friction stops it within about a wheelbase."""
    return math.sqrt(max(car["friction"], 0.1) * max(car["gravity"], 0.1) * wheelbase(car))


def motion(car, speed=None, yaw=None):
    """A state of any place and heading; speed and yaw rate in their usual sizes."""
    speed, yaw = (DRAW.normal() if value is None else value for value in (speed, yaw))
    place = DRAW.normal(size=2) * wheelbase(car)
    return np.array([*place, DRAW.uniform(-9, 9), speed * usual(car), yaw * usual(car) / wheelbase(car)])


def free_and_dragging(locked, car):
    return (-car["rear"], car["front"]) if locked == "front" else (car["front"], -car["rear"])


def velocity(at, state, locked, car):
    """Forward and left, of the point of the centreline so far forward of G: the free axle has none to the left."""
    return np.array([state[3], (at - free_and_dragging(locked, car)[0]) * state[4]])


def scales(state, car):
    """Of place, heading, speed and yaw rate."""
    v = abs(state[3]) + abs(state[4]) * wheelbase(car)
    way = v * v / (car["friction"] * car["gravity"]) if car["friction"] * car["gravity"] else wheelbase(car)
    return np.array([way, way, 1.0, v, v / wheelbase(car)])
