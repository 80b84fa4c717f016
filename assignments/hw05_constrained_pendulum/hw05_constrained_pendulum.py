"""hw05: The pendulum as a constrained particle.

figure.svg, beside this file, shows the axes, the names and the positive senses.

A particle in the plane is kept on the circle x^2 + y^2 = length^2 about a hinge at the origin by a radial force; x
right, y up. A state is (x, y, vx, vy). States are consistent, on the circle and tangent to it, but for the argument of
`consistent_state`. The potential energy is zero at y = 0.

Cartesian coordinates only: what is wanted is found from F = m a and the constraint, without an angle.
"""

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
    raise NotImplementedError


def constraint_force(state, *, mass, length, gravity):
    """The radial force that keeps the particle on the circle.

    state  : (4,) m, m/s
    mass   : kg
    length : m
    gravity: m/s^2, may be 0
    Returns (2,), N, the force on the particle.
    """
    raise NotImplementedError


def acceleration(state, *, mass, length, gravity):
    """Acceleration of the particle on the circle.

    state  : (4,) m, m/s
    mass   : kg
    length : m
    gravity: m/s^2, may be 0
    Returns (2,), m/s^2.
    """
    raise NotImplementedError


def consistent_state(state, *, length):
    """The state put on the circle: the position along its radius, the velocity without its radial part.

    state  : (4,) m, m/s
    length : m
    Returns (4,).
    Raises ValueError if the position is the origin.
    """
    raise NotImplementedError


def energy(state, *, mass, gravity):
    """Kinetic plus potential energy; the potential is 0 at y = 0.

    state  : (4,) m, m/s
    mass   : kg
    gravity: m/s^2, may be 0
    Returns J.
    """
    raise NotImplementedError


def simulate(t, state, *, mass, length, gravity):
    """Motion from `state` at t[0]; however long it is, it stays on the circle and tangent to it.

    t      : (n,) s, strictly increasing, n >= 2; its sampling does not change the motion
    state  : (4,) m, m/s
    mass   : kg
    length : m
    gravity: m/s^2, may be 0
    Returns (n, 4); row i is the state at t[i].
    """
    raise NotImplementedError


def wireframe(state, *, length):
    """The rod, from the hinge to the particle.

    state  : (4,) m, m/s
    length : m
    Returns (1, 2, 2), m.
    """
    raise NotImplementedError
