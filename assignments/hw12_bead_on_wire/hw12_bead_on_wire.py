"""hw12: A bead on the wire y = curvature x^2, without friction, gravity along -y.

figure.svg, beside this file, shows the axes, the names and the positive senses.

x is the generalised coordinate and v = dx/dt its rate, which is not the speed along the wire; curvature > 0.

Off limits in this file: tam570.lagrange and tam570.lectures, which would answer it.
"""

import numpy as np

__all__ = [
    "acceleration_newton",
    "constraint_force",
    "energy",
    "free_body_diagram",
    "lagrange_equation",
    "lagrangian",
    "period",
    "simulate",
]


def free_body_diagram(x, *, mass, curvature, gravity):
    """The forces on the bead, cut free from the wire.

    x        : m
    mass     : kg
    curvature: 1/m, > 0
    gravity  : m/s^2, may be 0
    Returns a list of pairs (point, direction), one for each force: where it acts, (2,) in m, and a vector (2,) of any
    length along which it acts, or None where neither component is known. The order is free.
    """
    raise NotImplementedError


def lagrangian():
    """Kinetic less potential energy of the bead.

    Returns a SymPy expression in the symbols x, v, m, c, g (c is the curvature).
    """
    raise NotImplementedError


def lagrange_equation():
    """The acceleration x'' by Lagrange's equation.

    Returns a SymPy expression in the symbols x, v, c, g (c is the curvature).
    """
    raise NotImplementedError


def acceleration_newton(x, v, *, curvature, gravity):
    """The acceleration x'' by Newton: F = m a, dotted with a tangent of the wire.

    x, v     : m, m/s
    curvature: 1/m, > 0
    gravity  : m/s^2, may be 0
    Returns m/s^2.
    """
    raise NotImplementedError


def constraint_force(x, v, *, mass, curvature, gravity):
    """Force of the wire on the bead, normal to the wire.

    x, v     : m, m/s
    mass     : kg
    curvature: 1/m, > 0
    gravity  : m/s^2, may be 0
    Returns (2,): x and y components, N.
    """
    raise NotImplementedError


def energy(x, v, *, mass, curvature, gravity):
    """Kinetic plus potential energy, zero at rest at the bottom.

    x, v     : m, m/s
    mass     : kg
    curvature: 1/m, > 0
    gravity  : m/s^2, may be 0
    Returns J.
    """
    raise NotImplementedError


def simulate(t, x, v, *, curvature, gravity):
    """Motion from x and v at t[0].

    t        : (n,) s, strictly increasing, n >= 2; its sampling does not change the motion
    x, v     : m, m/s
    curvature: 1/m, > 0
    gravity  : m/s^2, may be 0
    Returns (n, 2): x in m, v in m/s; row i is the state at t[i].
    """
    raise NotImplementedError


def period(amplitude, *, curvature, gravity):
    """Exact period of the motion between x = -amplitude and x = amplitude.

    amplitude: m, > 0
    curvature: 1/m, > 0
    gravity  : m/s^2, > 0
    Returns s.
    """
    raise NotImplementedError
