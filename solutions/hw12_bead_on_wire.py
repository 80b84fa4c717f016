"""hw12: A bead on the wire y = curvature x^2, without friction, gravity along -y.

figure.svg, beside this file, shows the axes, the names and the positive senses.

x is the generalised coordinate and v = dx/dt its rate, which is not the speed along the wire; curvature > 0.

Off limits in this file: tam570.lagrange and tam570.lectures, which would answer it.
"""

import math

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
    bead, slope = (x, curvature * x**2), 2 * curvature * x
    return [(bead, (0.0, -1.0)), (bead, (-slope, 1.0))]


def lagrangian():
    """Kinetic less potential energy of the bead.

    Returns a SymPy expression in the symbols x, v, m, c, g (c is the curvature).
    """
    import sympy

    x, v, mass, curvature, gravity = sympy.symbols("x v m c g")
    slope = 2 * curvature * x
    return mass * (1 + slope**2) * v**2 / 2 - mass * gravity * curvature * x**2


def lagrange_equation():
    """The acceleration x'' by Lagrange's equation.

    Returns a SymPy expression in the symbols x, v, c, g (c is the curvature).
    """
    import sympy

    x, v, mass = sympy.symbols("x v m")
    per_mass = lagrangian().subs(mass, 1)  # the mass is a factor of every term, and cancels
    momentum = sympy.diff(per_mass, v)
    force = sympy.diff(per_mass, x) - sympy.diff(momentum, x) * v
    return force / sympy.diff(momentum, v)


def acceleration_newton(x, v, *, curvature, gravity):
    """The acceleration x'' by Newton: F = m a, dotted with a tangent of the wire.

    x, v     : m, m/s
    curvature: 1/m, > 0
    gravity  : m/s^2, may be 0
    Returns m/s^2.
    """
    # a = (x'', slope x'' + 2 c v^2) and tangent = (1, slope): tangent . (a + g j) = 0 is free of the normal force.
    slope = 2 * curvature * x
    return -slope * (gravity + 2 * curvature * v**2) / (1 + slope**2)


def constraint_force(x, v, *, mass, curvature, gravity):
    """Force of the wire on the bead, normal to the wire.

    x, v     : m, m/s
    mass     : kg
    curvature: 1/m, > 0
    gravity  : m/s^2, may be 0
    Returns (2,): x and y components, N.
    """
    slope = 2 * curvature * x
    upward = mass * (gravity + 2 * curvature * v**2) / (1 + slope**2)
    return np.array([-slope * upward, upward])


def energy(x, v, *, mass, curvature, gravity):
    """Kinetic plus potential energy, zero at rest at the bottom.

    x, v     : m, m/s
    mass     : kg
    curvature: 1/m, > 0
    gravity  : m/s^2, may be 0
    Returns J.
    """
    slope = 2 * curvature * x
    return mass * (1 + slope**2) * v**2 / 2 + mass * gravity * curvature * x**2


def simulate(t, x, v, *, curvature, gravity):
    """Motion from x and v at t[0].

    t        : (n,) s, strictly increasing, n >= 2; its sampling does not change the motion
    x, v     : m, m/s
    curvature: 1/m, > 0
    gravity  : m/s^2, may be 0
    Returns (n, 2): x in m, v in m/s; row i is the state at t[i].
    """
    from tam570.integrate import solve

    # The speed along the wire varies gently where v jumps, at the bottom of a steep wire; and it makes the energy.
    parameters = {"curvature": curvature, "gravity": gravity}
    start = (x, v * _stretch(x, curvature))
    position, speed = np.transpose(solve(_sliding, t, start, parameters=parameters, rtol=5e-14))
    states = np.column_stack([position, speed / _stretch(position, curvature)])
    states[0] = x, v
    return states


def period(amplitude, *, curvature, gravity):
    """Exact period of the motion between x = -amplitude and x = amplitude.

    amplitude: m, > 0
    curvature: 1/m, > 0
    gravity  : m/s^2, > 0
    Returns s.
    """
    # With x = amplitude sin(phi) the energy gives sqrt(2 g c) dt = sqrt(cos^2 phi + b^2 sin^2 phi) dphi,
    # and that is the element of arc of an ellipse with semi-axes 1 and b.
    return _ellipse_perimeter(_stretch(amplitude, curvature)) / math.sqrt(2 * gravity * curvature)


def _stretch(x, curvature):
    """ds/dx: length of wire to a length along x."""
    return np.hypot(1.0, 2 * curvature * x)


def _sliding(t, state, *, curvature, gravity):
    """Rates of x and of the speed along the wire."""
    x, speed = state
    slope = 2 * curvature * x
    stretch = math.sqrt(1 + slope * slope)
    return speed / stretch, -gravity * slope / stretch


def _ellipse_perimeter(b):
    """Perimeter of the ellipse with semi-axes 1 and b >= 1, by the AGM (Abramowitz and Stegun 17.6).

    scipy.special.ellipe would do, but takes longer to import than all else.
    """
    mean, root, weight = b, 1.0, 1.0
    half_squares = (1 + b * b) / 2
    while mean - root > 1e-8 * mean:  # the square of it, that the next term is made of, is below rounding
        difference = (mean - root) / 2
        half_squares -= weight * difference**2
        mean, root, weight = (mean + root) / 2, math.sqrt(mean * root), 2 * weight
    return 2 * math.pi * half_squares / ((mean + root) / 2)
