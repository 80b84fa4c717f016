"""Reference functions of hw05: acceleration and constraint force from one linear system, motions from the angle."""

import math

import numpy as np

from tam570.integrate import solve
from tam570_grader.checks.diagrams import CENTRIFUGAL, INERTIAL, NEGLIGIBLE, Force, FreeBody, NotAForce, weight


def on_circle(theta, omega, length):
    """Return the state (..., 4) at an angle from straight down."""
    s, c, speed = np.sin(theta), np.cos(theta), length * np.asarray(omega)
    return np.stack([length * s, -length * c, speed * c, speed * s], axis=-1)


def together(state, mass, length, gravity):
    """Return acceleration and constraint force, from m a - N r = (0, -m g) and r . a = -v . v."""
    r, v = state[:2], state[2:]
    matrix = np.block([[mass * np.eye(2), -r[:, None]], [r, np.zeros(1)]])
    *a, pull = np.linalg.solve(matrix, [0.0, -mass * gravity, -v @ v])
    return np.array(a), pull * r


def acceleration(state, **parameters):
    return together(state, **parameters)[0]


def constraint_force(state, **parameters):
    return together(state, **parameters)[1]


def angle_and_rate(state, length):
    """Return the angle from straight down, and its rate on the circle, from the velocity across the radius."""
    x, y, vx, vy = state
    return math.atan2(x, -y), (x * vy - y * vx) / (math.hypot(x, y) * length)


def consistent_state(state, length):
    theta, omega = angle_and_rate(state, length)
    return on_circle(theta, omega, length)


def energy(state, mass, gravity):
    _, y, vx, vy = state
    return mass * ((vx**2 + vy**2) / 2 + gravity * y)


def wireframe(state, length):
    return np.array([[[0.0, 0.0], state[:2]]])


def simulate(t, state, mass, length, gravity):
    """Return (n, 4) states at the times t, by the angle from straight down."""

    def rates(_, angle):
        return angle[1], -gravity / length * math.sin(angle[0])

    angles = solve(rates, t, angle_and_rate(state, length), method="python")
    return np.vstack([state, on_circle(angles[1:, 0], angles[1:, 1], length)])


def energies(rows, mass, length, gravity):
    """Return the energy along a motion, over m g l, or m l^2/s^2 without gravity."""
    return energy(rows.T, 1.0, gravity) / ((gravity or 1.0) * length)


def free_body_diagram(state, mass, length, gravity):
    """Return the particle and its forces."""
    point, velocity = np.split(np.asarray(state, float), 2)
    tension = np.linalg.norm(constraint_force(state, mass=mass, length=length, gravity=gravity))
    strains = tension > NEGLIGIBLE * mass * (gravity + velocity @ velocity / length)
    rod = Force("the force of the rod", point, "the particle", point, acts=strains)
    wrong = (
        NotAForce(CENTRIFUGAL, point, point, sense=True),
        NotAForce(INERTIAL, point, acceleration(state, mass=mass, length=length, gravity=gravity)),
    )
    forces = weight(point, "the particle", gravity), rod
    return FreeBody("the particle", forces, wrong=wrong, outline=[[0 * point, point]])
