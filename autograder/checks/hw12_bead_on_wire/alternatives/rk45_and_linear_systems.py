"""Right: Newton with the normal force as an unknown of a linear system, RK45, a quadrature with a substitution."""

import numpy as np
import sympy
from scipy.integrate import quad, solve_ivp


def position(x, c):
    return x, c * x**2


def lagrangian():
    x, v, m, c, g = sympy.symbols("x v m c g")
    r = sympy.Matrix(position(x, c))
    velocity = r.diff(x) * v
    return m * velocity.dot(velocity) / 2 - m * g * r[1]


def lagrange_equation():
    x, v, a, m = sympy.symbols("x v a m")
    L = lagrangian()
    p = sympy.diff(L, v)
    equation = sympy.diff(p, x) * v + sympy.diff(p, v) * a - sympy.diff(L, x)
    right = sympy.simplify(sympy.solve(equation, a)[0])
    c, g = sympy.symbols("c g")
    less, place = g - 2 * c * v**2, 2 * c * x
    return sympy.expand(right * less * (1 + place**2)) / (less * (1 / place + place)) / place  # 0/0 at x = 0, at g = v = 0


def solved(x, v, mass, c, gravity):
    """x'' and the size of the normal force."""
    tangent = np.array([1.0, 2 * c * x])
    normal = np.array([-tangent[1], tangent[0]]) / np.linalg.norm(tangent)
    A = np.column_stack([mass * tangent, -normal])
    b = [0.0, -mass * gravity - mass * 2 * c * v**2]
    a, N = np.linalg.solve(A, b)
    return a, N * normal


def acceleration_newton(x, v, *, curvature, gravity):
    return solved(x, v, 1.0, curvature, gravity)[0]


def constraint_force(x, v, *, mass, curvature, gravity):
    return solved(x, v, mass, curvature, gravity)[1]


def energy(x, v, *, mass, curvature, gravity):
    velocity = np.array([1.0, 2 * curvature * x]) * v
    return 0.5 * mass * velocity @ velocity + mass * gravity * position(x, curvature)[1]


def simulate(t, x, v, *, curvature, gravity):
    def rhs(t, y):
        s = 2 * curvature * y[0]
        return y[1], -s * (gravity + 2 * curvature * y[1] ** 2) / (1 + s * s)

    return solve_ivp(rhs, (t[0], t[-1]), (x, v), dense_output=True, rtol=1e-9, atol=1e-9).sol(t).T


def period(amplitude, *, curvature, gravity):
    a = 2 * curvature * amplitude
    quarter = quad(lambda phi: np.sqrt(1 + (a * np.sin(phi)) ** 2), 0, np.pi / 2)[0]
    return 4 * quarter / np.sqrt(2 * gravity * curvature)


def free_body_diagram(x, *, mass, curvature, gravity):
    at = [x, curvature * x * x]
    return [[at, [-2 * curvature * x, 1]], [at, [0, -mass * gravity]]]
