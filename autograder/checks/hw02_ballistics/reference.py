"""What is right in hw02, by another route than the solution's: superposition. Each bit of speed that launch and gravity
give decays on its own, and the sum over them is done by Gauss's quadrature, which drag zero does not trouble.
"""

import math

import numpy as np

from tam570_grader.checks.diagrams import INERTIAL, Force, FreeBody, NotAForce, weight

NODES, WEIGHTS = (np.polynomial.legendre.leggauss(40)[0] + 1) / 2, np.polynomial.legendre.leggauss(40)[1] / 2


def means(s):
    """The means of e^(-s u) and of (1 - u) e^(-s u) over 0 < u < 1."""
    s = np.asarray(s, float)
    wide = np.maximum(s, 30.0)  # beyond, e^-s is below rounding beside 1
    decays = np.exp(-np.minimum(s, 30.0)[..., None] * NODES)
    first, second = decays @ WEIGHTS, decays @ (WEIGHTS * (1 - NODES))
    late = -np.expm1(-wide) / wide
    return np.where(s < 30, first, late), np.where(s < 30, second, (1 - late) / wide)


def state_derivative(t, state, mass, drag, gravity):
    velocity = state[2:]
    return np.concatenate([velocity, -drag / mass * velocity - (0, gravity)])


def trajectory(t, speed, angle, mass, drag, gravity):
    """Launched at t = 0."""
    vx, vy = speed * math.cos(angle), speed * math.sin(angle)
    mean, late = means(drag / mass * t)
    decay = np.exp(-drag / mass * t)
    fallen, fall_speed = gravity * t**2 * late, gravity * t * mean
    return np.column_stack([vx * t * mean, vy * t * mean - fallen, vx * decay, vy * decay - fall_speed])


def simulate(t, speed, angle, **parameters):
    """Launched at t[0]."""
    return trajectory(t - t[0], speed, angle, **parameters)


def flight_time(speed, angle, mass, drag, gravity):
    """By Newton's steps down from q = 2, the time in units of vy/g without drag: the height is concave in it."""
    vy = speed * math.sin(angle)
    lift = drag * vy / (mass * gravity)
    q, step = 2.0, 1.0
    while step > 1e-9:  # and the next is as its square
        mean, late = means(q * lift)
        step = q * (mean - q * late) / (math.exp(-q * lift) - q * mean)
        q -= step
    return q * vy / gravity


def landing(speed, angle, **parameters):
    """The state back at launch height."""
    return trajectory(np.array([flight_time(speed, angle, **parameters)]), speed, angle, **parameters)[0]


def horizontal_range(speed, angle, **parameters):
    return landing(speed, angle, **parameters)[0]


def best_angle(speed, mass, drag, gravity):
    """The angle of the largest range, at which it lands at right angles to the launch.

    The derivative of the range by the angle is x_a - x_t y_a/y_t with (x_a, y_a) along (-vy, vx) of the launch and
    (x_t, y_t) the velocity at the landing. Next to no drag it is pi/4 - sqrt(2)/6 c v/(m g).
    """
    swiftness = drag * speed / (mass * gravity)
    if swiftness < 1e-6:
        return math.pi / 4 - math.sqrt(2) / 6 * swiftness

    low, high = math.log(1e-10), 0.0  # of the angle's logarithm, which the halvings make good to 1e-11
    for _ in range(40):
        middle = (low + high) / 2
        angle = math.exp(middle)
        _, _, vx, vy = landing(swiftness, angle, mass=1.0, drag=1.0, gravity=1.0)
        low, high = (middle, high) if math.cos(angle) * vx + math.sin(angle) * vy > 0 else (low, middle)
    return math.exp((low + high) / 2)


def limit_shape(angle):
    """Of the path at a speed of 1e12 times the terminal speed: launch, end of the drag's work, landing."""
    speed = 1e12
    times = np.array([0.0, 40.0, speed * math.sin(angle)])  # e^-40 is nothing, and 40/1e12 too
    return trajectory(times, speed, angle, mass=1.0, drag=1.0, gravity=1.0)[:, :2] / speed


ALONG_THE_VELOCITY = "You drew the drag along the velocity: this is the force that the particle exerts on the air."
NO_THRUST = "You drew a force along the velocity; after the launch no other body pushes the particle."


def free_body_diagram(state, mass, drag, gravity):
    """Of the particle."""
    point, velocity = np.split(np.asarray(state, float), 2)
    acts = drag != 0 and bool(velocity.any())
    forces = (
        weight(point, "the particle", gravity),
        Force("the drag", point, "the particle", -velocity, sense=True, acts=acts, reversed=ALONG_THE_VELOCITY),
    )
    acceleration = state_derivative(0.0, state, mass, drag, gravity)[2:]
    wrong = NotAForce(NO_THRUST, point, velocity, sense=True), NotAForce(INERTIAL, point, acceleration)
    return FreeBody("the particle", forces, wrong=wrong)
