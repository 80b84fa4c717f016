"""Right functions of hw12 in other forms, or that follow from others; diagnosis tries mistakes in these, too."""

import math


def lagrangian():
    """Use x' and y'."""
    import sympy

    x, v, mass, curvature, gravity = sympy.symbols("x v m c g")
    return mass * (v**2 + (2 * curvature * x * v) ** 2) / 2 - mass * gravity * curvature * x**2


def acceleration_newton(x, v, *, curvature, gravity):
    slope = _slope(x, curvature)
    return -slope * (gravity + 2 * curvature * v**2) / (1 + slope**2)


def constraint_force(x, v, *, mass, curvature, gravity):
    """Subtract the weight from m times the acceleration: x'', and y'' = 2 c (v^2 + x x'')."""
    acceleration = acceleration_newton(x, v, curvature=curvature, gravity=gravity)
    return mass * acceleration, mass * (2 * curvature * (v**2 + x * acceleration) + gravity)


def energy(x, v, *, mass, curvature, gravity):
    speed = math.hypot(v, _slope(x, curvature) * v)
    return mass * speed**2 / 2 + mass * gravity * curvature * x**2


def _slope(x, curvature):
    return 2 * curvature * x
