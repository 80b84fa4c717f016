"""hw06: A car going straight ahead with the brakes of one axle locked: does it stay straight?

figure.svg, beside this file, shows the axes, the names and the positive senses.

The ground plane is x, y; heading is the angle from the x axis to the car's forward direction, counter-clockwise
positive, never wrapped. G is on the centreline, at ground height, `front` behind the front axle and `rear` ahead of
the rear one. The free axle rolls and does not slip sideways; the locked axle drags, as one point on the centreline,
with Coulomb friction: `friction` times its static load, against the velocity of that point. `locked` is "front" or
"rear".

state = x, y of G; heading; speed, the forward component of velocity, the same for all points of the centreline,
negative in reverse; yaw_rate, the rate of heading.
"""

import numpy as np

__all__ = [
    "axle_load",
    "critical_speed",
    "free_body_diagram",
    "friction_force",
    "kinetic_energy",
    "simulate",
    "small_yaw_rate",
    "state_derivative",
    "yaw_growth_rate",
]


def free_body_diagram(state, locked, *, mass, front, rear, friction, gravity):
    """The forces on the car in the plane of the ground, seen from above.

    state       : (5,) x, y, heading, speed, yaw_rate
    locked      : "front" or "rear"
    mass        : kg
    front, rear : m, > 0, from G to the axles
    friction    : coefficient, may be 0
    gravity     : m/s^2, may be 0
    Returns a list of pairs (point, direction), one for each force: where it acts, (2,) in m, and a vector (2,) of any
    length along which it acts, or None where neither component is known, both along x and y of the ground. The order
    is free.
    Raises ValueError for another `locked`.
    """
    raise NotImplementedError


def axle_load(locked, *, mass, front, rear, gravity):
    """Load that the locked axle carries.

    locked      : "front" or "rear"
    mass        : kg
    front, rear : m, > 0, from G to the axles
    gravity     : m/s^2, may be 0
    Returns N.
    Raises ValueError for another `locked`.
    """
    raise NotImplementedError


def friction_force(state, locked, *, mass, front, rear, friction, gravity):
    """Force of the ground on the car at the locked axle, against its velocity; zero at rest.

    state       : (5,) x, y, heading, speed, yaw_rate
    locked      : "front" or "rear"
    mass        : kg
    front, rear : m, > 0, from G to the axles
    friction    : coefficient, may be 0
    gravity     : m/s^2, may be 0
    Returns (2,): forward and left components, N.
    Raises ValueError for another `locked`.
    """
    raise NotImplementedError


def state_derivative(t, state, locked, *, mass, yaw_inertia, front, rear, friction, gravity):
    """Rates of x, y, heading, speed and yaw_rate; all zero at rest.

    t           : s, not used
    state       : (5,) x, y, heading, speed, yaw_rate
    locked      : "front" or "rear"
    mass        : kg
    yaw_inertia : kg m^2, about G
    front, rear : m, > 0, from G to the axles
    friction    : coefficient, may be 0
    gravity     : m/s^2, may be 0
    Returns (5,).
    Raises ValueError for another `locked`.
    """
    raise NotImplementedError


def simulate(t, state, locked, *, mass, yaw_inertia, front, rear, friction, gravity):
    """Motion from `state` at t[0]; a car that has come to rest stays.

    t           : (n,) s, strictly increasing, n >= 2; its sampling does not change the motion
    state       : (5,) x, y, heading, speed, yaw_rate
    locked      : "front" or "rear"
    mass        : kg
    yaw_inertia : kg m^2, about G
    front, rear : m, > 0, from G to the axles
    friction    : coefficient, may be 0
    gravity     : m/s^2, may be 0
    Returns (n, 5); row i is the state at t[i].
    Raises ValueError for another `locked`.
    """
    raise NotImplementedError


def kinetic_energy(state, locked, *, mass, yaw_inertia, front, rear):
    """Kinetic energy of the car.

    state       : (5,) x, y, heading, speed, yaw_rate
    locked      : "front" or "rear"
    mass        : kg
    yaw_inertia : kg m^2, about G
    front, rear : m, > 0, from G to the axles
    Returns J.
    Raises ValueError for another `locked`.
    """
    raise NotImplementedError


def yaw_growth_rate(speed, locked, *, mass, yaw_inertia, front, rear, friction, gravity):
    """d(yaw acceleration)/d(yaw_rate) about straight motion: positive where a small yaw rate grows.

    speed       : m/s, > 0
    locked      : "front" or "rear"
    mass        : kg
    yaw_inertia : kg m^2, about G
    front, rear : m, > 0, from G to the axles
    friction    : coefficient, may be 0
    gravity     : m/s^2, may be 0
    Returns 1/s.
    Raises ValueError for another `locked`.
    """
    raise NotImplementedError


def critical_speed(locked, *, front, rear, friction, gravity):
    """Speed above which straight motion is unstable; math.inf where it never is.

    locked      : "front" or "rear"
    front, rear : m, > 0, from G to the axles
    friction    : coefficient, may be 0
    gravity     : m/s^2, may be 0
    Returns m/s; 0 for locked rear wheels without friction.
    Raises ValueError for another `locked`.
    """
    raise NotImplementedError


def small_yaw_rate(speed, speed0, yaw_rate0, locked, *, mass, yaw_inertia, front, rear, friction, gravity):
    """Yaw rate at `speed` of a car that had yaw_rate0 at speed0, exact by the equations linear in the yaw rate.

    speed       : m/s, 0 < speed <= speed0
    speed0      : m/s
    yaw_rate0   : rad/s
    locked      : "front" or "rear"
    mass        : kg
    yaw_inertia : kg m^2, about G
    front, rear : m, > 0, from G to the axles
    friction    : coefficient, > 0
    gravity     : m/s^2, > 0
    Returns rad/s.
    Raises ValueError for another `locked`.
    """
    raise NotImplementedError
