"""Reference functions of hw02, by superposition, unlike the solution.

Each increment of speed from launch and gravity decays separately; Gauss's quadrature, valid for zero drag, sums them.
"""

import math

import numpy as np

from tam570_grader.checks.diagrams import INERTIAL, Force, FreeBody, NotAForce, weight

NODES, WEIGHTS = (np.polynomial.legendre.leggauss(40)[0] + 1) / 2, np.polynomial.legendre.leggauss(40)[1] / 2


def means(s):
    """Return the means of e^(-s u) and of (1 - u) e^(-s u) over 0 < u < 1."""
    s = np.asarray(s, float)
    wide = np.maximum(s, 30.0)  # for larger s, e^-s is below the rounding error of 1
    decays = np.exp(-np.minimum(s, 30.0)[..., None] * NODES)
    first, second = decays @ WEIGHTS, decays @ (WEIGHTS * (1 - NODES))
    late = -np.expm1(-wide) / wide
    return np.where(s < 30, first, late), np.where(s < 30, second, (1 - late) / wide)


def state_derivative(t, state, mass, drag, gravity):
    velocity = state[2:]
    return np.concatenate([velocity, -drag / mass * velocity - (0, gravity)])


def trajectory(t, speed, angle, mass, drag, gravity):
    """Return the states after a launch at t = 0."""
    vx, vy = speed * math.cos(angle), speed * math.sin(angle)
    mean, late = means(drag / mass * t)
    decay = np.exp(-drag / mass * t)
    fallen, fall_speed = gravity * t**2 * late, gravity * t * mean
    return np.column_stack([vx * t * mean, vy * t * mean - fallen, vx * decay, vy * decay - fall_speed])


def simulate(t, speed, angle, **parameters):
    """Return the states after a launch at t[0]."""
    return trajectory(t - t[0], speed, angle, **parameters)


def flight_time(speed, angle, mass, drag, gravity):
    """Solve by Newton's steps down from q = 2, the time in units of vy/g without drag: the height is concave in q."""
    vy = speed * math.sin(angle)
    lift = drag * vy / (mass * gravity)
    q, step = 2.0, 1.0
    while step > 1e-9:  # the next step is about its square
        mean, late = means(q * lift)
        step = q * (mean - q * late) / (math.exp(-q * lift) - q * mean)
        q -= step
    return q * vy / gravity


def landing(speed, angle, **parameters):
    """Return the state back at launch height."""
    return trajectory(np.array([flight_time(speed, angle, **parameters)]), speed, angle, **parameters)[0]


def horizontal_range(speed, angle, **parameters):
    return landing(speed, angle, **parameters)[0]


def best_angle(speed, mass, drag, gravity):
    """Return the angle of the largest range, at which the particle lands at right angles to the launch.

    The derivative of the range by the angle is x_a - x_t y_a/y_t with (x_a, y_a) along (-vy, vx) of the launch and
    (x_t, y_t) the velocity at the landing. For very little drag the angle is pi/4 - sqrt(2)/6 c v/(m g).
    """
    swiftness = drag * speed / (mass * gravity)
    if swiftness < 1e-6:
        return math.pi / 4 - math.sqrt(2) / 6 * swiftness

    low, high = math.log(1e-10), 0.0  # bounds of the angle's logarithm; the halvings find it to 1e-11
    for _ in range(40):
        middle = (low + high) / 2
        angle = math.exp(middle)
        _, _, vx, vy = landing(swiftness, angle, mass=1.0, drag=1.0, gravity=1.0)
        low, high = (middle, high) if math.cos(angle) * vx + math.sin(angle) * vy > 0 else (low, middle)
    return math.exp((low + high) / 2)


def limit_shape(angle):
    """Return launch, end of the drag's work and landing, for a speed of 1e12 times the terminal speed, over m v/c."""
    speed = 1e12
    times = np.array([0.0, 40.0, speed * math.sin(angle)])  # e^-40 and 40/1e12 are negligible
    return trajectory(times, speed, angle, mass=1.0, drag=1.0, gravity=1.0)[:, :2] / speed


ALONG_THE_VELOCITY = "You drew the drag along the velocity: this is the force that the particle exerts on the air."
NO_THRUST = "You drew a force along the velocity; after the launch no other body pushes the particle."


def free_body_diagram(state, mass, drag, gravity):
    """Return the particle and its forces."""
    point, velocity = np.split(np.asarray(state, float), 2)
    acts = drag != 0 and bool(velocity.any())
    forces = (
        weight(point, "the particle", gravity),
        Force("the drag", point, "the particle", -velocity, sense=True, acts=acts, reversed=ALONG_THE_VELOCITY),
    )
    acceleration = state_derivative(0.0, state, mass, drag, gravity)[2:]
    wrong = NotAForce(NO_THRUST, point, velocity, sense=True), NotAForce(INERTIAL, point, acceleration)
    return FreeBody("the particle", forces, wrong=wrong)
