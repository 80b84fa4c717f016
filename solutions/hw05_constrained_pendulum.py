"""hw05: The pendulum as a constrained particle.

figure.svg, beside this file, shows the axes, the names and the positive senses.

A particle in the plane is kept on the circle x^2 + y^2 = length^2 about a hinge at the origin by a radial force; x
right, y up. A state is (x, y, vx, vy). States are consistent, on the circle and tangent to it, but for the argument of
`consistent_state`. The potential energy is zero at y = 0.

Cartesian coordinates only: what is wanted is found from F = m a and the constraint, without an angle.
"""

import math

import numpy as np

__all__ = [
    "acceleration",
    "consistent_state",
    "constraint_force",
    "energy",
    "free_body_diagram",
    "simulate",
    "wireframe",
]


def free_body_diagram(state, *, mass, length, gravity):
    """The forces on the particle, cut free from the rod.

    state  : (4,) m, m/s
    mass   : kg
    length : m
    gravity: m/s^2, may be 0
    Returns a list of pairs (point, direction), one for each force: where it acts, (2,) in m, and a vector (2,) of any
    length along which it acts, or None where neither component is known. The order is free.
    """
    x, y, _, _ = state
    return [((x, y), (0.0, -1.0)), ((x, y), (-x, -y))]


def constraint_force(state, *, mass, length, gravity):
    """The radial force that keeps the particle on the circle.

    state  : (4,) m, m/s
    mass   : kg
    length : m
    gravity: m/s^2, may be 0
    Returns (2,), N, the force on the particle.
    """
    x, y, vx, vy = state
    along = np.array([x, y]) / length
    outward = mass * gravity * along[1] - mass * (vx**2 + vy**2) / length  # x^2 + y^2 = l^2 differentiated twice
    return outward * along


def acceleration(state, *, mass, length, gravity):
    """Acceleration of the particle on the circle.

    state  : (4,) m, m/s
    mass   : kg
    length : m
    gravity: m/s^2, may be 0
    Returns (2,), m/s^2.
    """
    force = constraint_force(state, mass=mass, length=length, gravity=gravity)
    return force / mass - np.array([0.0, gravity])


def consistent_state(state, *, length):
    """The state put on the circle: the position along its radius, the velocity without its radial part.

    state  : (4,) m, m/s
    length : m
    Returns (4,).
    Raises ValueError if the position is the origin.
    """
    x, y, vx, vy = state
    distance = math.hypot(x, y)
    if distance == 0:
        raise ValueError("state: at the origin there is no nearest point of the circle")
    x, y = x / distance, y / distance
    along = x * vy - y * vx
    return np.array([length * x, length * y, -along * y, along * x])


def energy(state, *, mass, gravity):
    """Kinetic plus potential energy; the potential is 0 at y = 0.

    state  : (4,) m, m/s
    mass   : kg
    gravity: m/s^2, may be 0
    Returns J.
    """
    _, y, vx, vy = state
    return mass * (vx**2 + vy**2) / 2 + mass * gravity * y


def simulate(t, state, *, mass, length, gravity):
    """Motion from `state` at t[0]; however long it is, it stays on the circle and tangent to it.

    t      : (n,) s, strictly increasing, n >= 2; its sampling does not change the motion
    state  : (4,) m, m/s
    mass   : kg
    length : m
    gravity: m/s^2, may be 0
    Returns (n, 4); row i is the state at t[i].
    """
    from tam570.integrate import solve

    x, y, vx, vy = state
    # A radial force has no moment about the hinge, and the velocity is across the radius: x vy - y vx alone says it.
    start = x / length, y / length, (x * vy - y * vx) / length**2
    rows = solve(_rates, t, start, parameters={"pull": gravity / length}, rtol=1e-15)
    unit = rows[:, :2] / np.hypot(rows[:, 0], rows[:, 1])[:, None]
    across = np.column_stack([-unit[:, 1], unit[:, 0]])
    states = length * np.hstack([unit, rows[:, 2:] * across])
    states[0] = state
    return states


def wireframe(state, *, length):
    """The rod, from the hinge to the particle.

    state  : (4,) m, m/s
    length : m
    Returns (1, 2, 2), m.
    """
    return np.array([[[0.0, 0.0], state[:2]]])


def _rates(t, state, *, pull):
    """Rates of the unit vector (x, y)/l and of (x vy - y vx)/l^2."""
    x, y, turning = state
    return -turning * y, turning * x, -pull * x
