"""Reference functions of hw12, derived differently from the solution: the bend of the wire, an elliptic integral."""

import math

import numpy as np

from tam570.integrate import solve
from tam570_grader.checks.diagrams import Force, FreeBody, NotAForce, weight

STEP = 0.25  # step of a sum that replaces an integral; its error is exp(-pi^2/STEP)


def acceleration_newton(x, v, curvature, gravity):
    """Return x'': only the wire pushes sideways."""
    return constraint_force(x, v, 1.0, curvature, gravity)[0]


def constraint_force(x, v, mass, curvature, gravity):
    """Return the force, along the normal: mass times speed^2 over the radius of curvature, and the weight's share."""
    angle = math.atan(2 * curvature * x)  # of the wire with the horizontal
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
    """Compute Legendre's complete integral of the second kind by a sum over log(tan), which converges exponentially."""
    tangent, stretch = np.exp(STEP * np.arange(-200, 200)), math.hypot(1, 2 * curvature * amplitude)
    arcs = np.hypot(1, stretch * tangent) * tangent / np.hypot(1, tangent) ** 3
    return 4 * STEP * np.sum(arcs) / math.sqrt(2 * gravity * curvature)


def simulate(t, x, v, curvature, gravity):
    """Return (n, 2) states, by Lagrange's equation."""

    def rates(_, state):
        x, v = state
        slope = 2 * curvature * x
        return v, -slope * (2 * curvature * v**2 + gravity) / (1 + slope**2)

    return solve(rates, t, (x, v), method="python")


def energy_of_rows(rows, curvature, gravity):
    """Return the energy of a bead of 1 kg along a motion."""
    x, v = rows.T
    return energy(x, v, 1.0, curvature, gravity)


VERTICAL = "You drew the force of the wire along the vertical. Without friction it is normal to the wire."
ALONG_THE_WIRE = "You drew a force along the wire. There is no friction, and no other body exerts m a."
SECOND_NORMAL = "You drew a second force along the normal. No other body exerts a centrifugal force or m a."


def free_body_diagram(x, mass, curvature, gravity):
    """Return the bead and its forces."""
    point, angle = [x, curvature * x**2], math.atan(2 * curvature * x)
    normal, tangent = (-math.sin(angle), math.cos(angle)), (math.cos(angle), math.sin(angle))
    wrong = (
        NotAForce(VERTICAL, point, (0.0, 1.0), sense=True),
        NotAForce(ALONG_THE_WIRE, point, tangent),
        NotAForce(SECOND_NORMAL, point, normal),
    )
    forces = weight(point, "the bead", gravity), Force("the force of the wire", point, "the bead", normal)
    return FreeBody("the bead", forces, wrong=wrong, outline=_wire(x, curvature))


def _wire(x, curvature):
    """Return (k, 2, 2) m, the wire around a place."""
    places = x + np.linspace(-0.6, 0.6, 13) * max(abs(x), 1 / curvature)
    points = np.column_stack([places, curvature * places**2])
    return np.stack([points[:-1], points[1:]], axis=1)
