"""Reference functions of hw01, derived differently from the solution: vectors in the plane, an elliptic integral."""

import cmath
import math

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from tam570.integrate import solve
from tam570_grader.checks.diagrams import CENTRIFUGAL, INERTIAL, NEGLIGIBLE, Force, FreeBody, NotAForce, weight

STEP = 0.25  # step of a sum that replaces an integral; its error is exp(-pi^2/STEP)
NODES, WEIGHTS = (np.polynomial.legendre.leggauss(4)[0] + 1) / 2, np.polynomial.legendre.leggauss(4)[1] / 2


def vectors(theta, omega, mass, length, gravity):
    """Return r, v, the weight, and a unit vector across the rod, as complex numbers x + iy."""
    along = -1j * cmath.exp(1j * theta)
    return length * along, 1j * omega * length * along, -1j * mass * gravity, 1j * along


def dot(a, b):
    return (a.conjugate() * b).real


def cross(a, b):
    return (a.conjugate() * b).imag


def alpha(theta, omega, mass, length, gravity):
    *_, weight, across = vectors(theta, omega, mass, length, gravity)
    return dot(across, weight) / (mass * length)


def linear_momentum_balance(*state, **pendulum):
    r, v, weight, _ = vectors(*state, **pendulum)
    m, length = pendulum["mass"], pendulum["length"]
    return alpha(*state, **pendulum), dot(r, weight) / length + m * dot(v, v) / length


def angular_momentum_balance(*state, **pendulum):
    r, v, weight, _ = vectors(*state, **pendulum)
    return alpha(*state, **pendulum), pendulum["mass"] * cross(r, v), cross(r, weight)


def energy_balance(*state, **pendulum):
    r, v, weight, _ = vectors(*state, **pendulum)
    return alpha(*state, **pendulum), pendulum["mass"] * dot(v, v) / 2, abs(weight) * (r.imag + pendulum["length"])


def power_balance(*state, **pendulum):
    _, v, weight, _ = vectors(*state, **pendulum)
    return alpha(*state, **pendulum), dot(weight, v)


def virtual_work(*state, **pendulum):
    *_, weight, across = vectors(*state, **pendulum)
    return alpha(*state, **pendulum), pendulum["length"] * dot(across, weight)


def lagrangian(theta, omega, m, l, g):  # noqa: E741  the contract's symbol
    _, kinetic, potential = energy_balance(theta, omega, mass=m, length=l, gravity=g)
    return kinetic - potential


def lagrange_equation(theta, l, g):  # noqa: E741
    return alpha(theta, 0.0, 1.0, l, g)


def action(theta, step, mass, length, gravity):
    """Use Gauss's quadrature for each step, on the polynomial through the six samples around it, or through all."""
    steps, size = np.arange(len(theta) - 1), min(6, len(theta))
    first = np.clip(steps - (size - 2) // 2, 0, len(theta) - size)
    powers = np.arange(size)
    polynomials = np.linalg.solve(powers[:, None] ** powers, sliding_window_view(theta, size)[first].T)
    at = (steps - first + NODES[:, None])[..., None]
    angle = np.einsum("qnk,kn->qn", at**powers, polynomials)
    omega = np.einsum("qnk,kn->qn", at ** powers[:-1], powers[1:, None] * polynomials[1:]) / step
    values = mass * length * (length * omega**2 / 2 - 2 * gravity * np.sin(angle / 2) ** 2)
    return float(step * np.sum(WEIGHTS @ values))


def small_angle_solution(t, theta0, omega0, length, gravity):
    """Use a complex exponential, or a constant rate without gravity."""
    k = math.sqrt(gravity / length)
    if k == 0:
        return np.column_stack([theta0 + omega0 * t, np.full(len(t), omega0)])
    z = (theta0 - 1j * omega0 / k) * np.exp(1j * k * t)
    return np.column_stack([z.real, -k * z.imag])


def period(amplitude, length, gravity):
    """Compute Legendre's complete integral of the first kind by a sum over log(tan), which converges exponentially."""
    tangent, narrow = np.exp(STEP * np.arange(-200, 400)), math.cos(amplitude / 2)
    angles = tangent / (np.hypot(1, tangent) * np.hypot(1, narrow * tangent))
    return 4 * STEP * np.sum(angles) * math.sqrt(length / gravity)


def simulate(t, theta0, omega0, length, gravity):
    """Return (n, 2) states."""

    def rates(_, state):
        return state[1], -gravity / length * math.sin(state[0])

    return solve(rates, t, (theta0, omega0), method="python")


def energy_of_rows(rows, length, gravity):
    """Return the energy along a motion for m l^2 = 1 kg m^2, zero at the lowest point."""
    theta, omega = rows.T
    return omega**2 / 2 + 2 * gravity / length * np.sin(theta / 2) ** 2


def free_body_diagram(theta, omega, mass, length, gravity):
    """Return the mass and its forces; m a is a wrong arrow, in full, and in parts across and along the rod."""
    r, v, pull, across = vectors(theta, omega, mass, length, gravity)
    tension = linear_momentum_balance(theta, omega, mass=mass, length=length, gravity=gravity)[1]
    strains = abs(tension) > NEGLIGIBLE * (abs(pull) + mass * abs(v) ** 2 / length)
    swing, inward = alpha(theta, omega, mass, length, gravity) * length * across, -(omega**2) * r
    point, down, rod, *parts = ([z.real, z.imag] for z in (r, pull, r, swing + inward, swing, inward))
    forces = weight(point, "the mass", gravity), Force("the force of the rod", point, "the mass", rod, acts=strains)
    wrong = NotAForce(CENTRIFUGAL, point, rod, sense=True), *(NotAForce(INERTIAL, point, part) for part in parts)
    return FreeBody("the mass", forces, wrong=wrong, outline=[[[0.0, 0.0], point]])
