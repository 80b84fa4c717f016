"""Show that symbols with assumptions, another zero level and Legendre's integral pass."""

import numpy as np
import sympy as sp
from scipy.integrate import solve_ivp
from scipy.special import ellipe


def lagrangian():
    x, v = sp.symbols("x v", real=True)
    m, c, g = sp.symbols("m c g", positive=True)
    return sp.expand(m * (v**2 + (2 * c * x * v) ** 2) / 2 - m * g * c * x**2) + 3 * m * g / c  # zero level elsewhere


def lagrange_equation():
    x, v = sp.symbols("x v", real=True)
    c, g = sp.symbols("c g", positive=True)
    return -(2 * g * c * x + 4 * c**2 * x * v**2) / (1 + 4 * c**2 * x**2)


def acceleration_newton(x, v, *, curvature, gravity):
    c = curvature
    return -(2 * gravity * c * x + 4 * c**2 * x * v**2) / (1 + 4 * c**2 * x**2)


def constraint_force(x, v, *, mass, curvature, gravity):
    ax = acceleration_newton(x, v, curvature=curvature, gravity=gravity)
    ay = 2 * curvature * v**2 + 2 * curvature * x * ax
    return [mass * ax, mass * (ay + gravity)]


def energy(x, v, *, mass, curvature, gravity):
    return mass * (v**2 + 4 * curvature**2 * x**2 * v**2) / 2 + mass * gravity * curvature * x**2


def simulate(t, x, v, *, curvature, gravity):
    def rhs(t, y):
        return [y[1], acceleration_newton(y[0], y[1], curvature=curvature, gravity=gravity)]

    return solve_ivp(rhs, (t[0], t[-1]), [x, v], t_eval=t, method="DOP853", rtol=1e-9, atol=1e-9).y.T.tolist()


def period(amplitude, *, curvature, gravity):
    return 4 / np.sqrt(2 * curvature * gravity) * ellipe(-((2 * curvature * amplitude) ** 2))


def free_body_diagram(x, *, mass, curvature, gravity):
    at = [x, curvature * x * x]
    return [[at, [-2 * curvature * x, 1]], [at, [0, -mass * gravity]]]
