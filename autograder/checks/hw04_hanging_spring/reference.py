"""Reference functions of hw04: a matrix exponential, the oscillator's (Fradkin's) tensor, and turned coordinates."""

import math

import numpy as np

from tam570_grader.checks.diagrams import INERTIAL, Force, FreeBody, NotAForce, weight

Z = np.array([0.0, 0.0, 1.0])


def rate_of(mass, stiffness, gravity):
    return math.sqrt(stiffness / mass)


def generator(mass, stiffness, gravity):
    """Return the matrix of the linear equation for (r, v, 1)."""
    matrix = np.zeros((7, 7))
    matrix[:3, 3:6] = np.eye(3)
    matrix[3:6, :3] = -stiffness / mass * np.eye(3)
    matrix[5, 6] = -gravity
    return matrix


def state_derivative(t, state, **parameters):
    return (generator(**parameters) @ [*state, 1.0])[:6]


def energy(state, mass, stiffness, gravity):
    matrix = np.diag([stiffness] * 3 + [mass] * 3)
    return state @ matrix @ state / 2 + mass * gravity * state[2]


def solution(t, position, velocity, **parameters):
    """Return (n, 6) states; position and velocity are those at t = 0.

    The generator A satisfies A^3 = -rate^2 A, as that of a rotation: its exponential is Rodrigues' formula.
    """
    matrix, start, rate = generator(**parameters), np.array([*position, *velocity, 1.0]), rate_of(**parameters)
    angle = rate * np.reshape(t, (-1, 1))
    sine, versine = np.sin(angle) / rate, 2 * (np.sin(angle / 2) / rate) ** 2
    return (start + sine * (matrix @ start) + versine * (matrix @ matrix @ start))[:, :6]


def simulate(t, position, velocity, **parameters):
    """Return (n, 6) states; position and velocity are those at t[0]."""
    return solution(t - t[0], position, velocity, **parameters)


def centre(mass, stiffness, gravity):
    return -mass * gravity / stiffness * Z


def energies(states, mass, stiffness, gravity):
    """Return (n,) energies, J, relative to the equilibrium."""
    places = states[:, :3] - centre(mass, stiffness, gravity)
    return (stiffness * np.sum(places**2, axis=1) + mass * np.sum(states[:, 3:] ** 2, axis=1)) / 2


def orbit(position, velocity, **parameters):
    """Return the centre, and Fradkin's tensor over stiffness/2: its eigenvalues are the squares of the semi-axes."""
    radius = position - centre(**parameters)
    return centre(**parameters), np.outer(radius, radius) + np.outer(velocity, velocity) / rate_of(**parameters) ** 2


def project(points, azimuth, elevation):
    """Return the points in coordinates turned by the azimuth about z, then by the elevation about the y axis."""
    plane = (points[:, 0] + 1j * points[:, 1]) * np.exp(-1j * azimuth)
    tilted = (plane.real + 1j * points[:, 2]) * np.exp(-1j * elevation)
    return np.column_stack([plane.imag, tilted.imag])


PUSHES = "You let the spring push. Its rest length is zero: it always pulls towards the origin."


def free_body_diagram(state, mass, stiffness, gravity):
    """Return the mass and its forces."""
    point = np.asarray(state[:3], float)
    spring = Force(
        "the force of the spring", point, "the mass", -point, sense=True, acts=bool(point.any()), reversed=PUSHES
    )
    acceleration = -stiffness / mass * point - gravity * Z
    wrong = (NotAForce(INERTIAL, point, acceleration),)
    return FreeBody(
        "the mass", (weight(point, "the mass", gravity, -Z), spring), wrong=wrong, outline=[[0 * point, point]]
    )
