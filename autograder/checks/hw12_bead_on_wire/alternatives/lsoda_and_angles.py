"""Show that the wire's angle as variable, positive symbols, another zero level, odeint, a singular quadrature pass."""

import math

import sympy
from scipy.integrate import odeint, quad


def lagrangian():
    (x, v), (m, c, g) = sympy.symbols("x v", real=True), sympy.symbols("m c g", positive=True)
    angle = sympy.atan(2 * c * x)
    return m / 2 * (v / sympy.cos(angle)) ** 2 - m * g * c * x**2 + 3 * m * g / c


def lagrange_equation():
    x, v, c, g = sympy.symbols("x v c g")
    return v**2 * sympy.diff(-sympy.log(1 + (2 * c * x) ** 2) / 2, x) - 2 * c * g * x / (1 + (2 * c * x) ** 2)


def acceleration_newton(x, v, *, curvature, gravity):
    angle = math.atan(2 * curvature * x)
    s, k = math.sin(angle), math.cos(angle)
    return -gravity * s * k - 2 * curvature * s * k * v**2


def constraint_force(x, v, *, mass, curvature, gravity):
    angle = math.atan(2 * curvature * x)
    s, k = math.sin(angle), math.cos(angle)
    N = mass * (gravity * k + 2 * curvature * k**3 * (v / k) ** 2)
    return -N * s, N * k


def energy(x, v, *, mass, curvature, gravity):
    return mass * ((v * math.hypot(1, 2 * curvature * x)) ** 2 / 2 + gravity * curvature * x * x)


def simulate(t, x, v, *, curvature, gravity):
    def rates(y, t):
        return y[1], acceleration_newton(y[0], y[1], curvature=curvature, gravity=gravity)

    return odeint(rates, (x, v), t, rtol=1e-9, atol=1e-9, mxstep=10000)


def period(amplitude, *, curvature, gravity):
    def integrand(x):
        return math.sqrt((1 + (2 * curvature * x) ** 2) / ((amplitude - x) * (amplitude + x)))

    return 4 / math.sqrt(2 * gravity * curvature) * quad(integrand, 0, amplitude, limit=200)[0]


def free_body_diagram(x, *, mass, curvature, gravity):
    bead, slope = (x, curvature * x**2), 2 * curvature * x
    size = (1 + slope**2) ** 0.5
    wire = (bead, (slope / size, -1 / size))  # it may push or pull
    return [wire, (bead, (0.0, -1.0))] if gravity else [wire]
