"""Show that SymPy's euler_equations pass, and a simulation of its lambdified result."""
import matplotlib.pyplot as plt  # noqa: F401
import numpy as np
import sympy as sp
from scipy.integrate import solve_ivp
from scipy.special import ellipe
from sympy.calculus.euler import euler_equations

x_, v_, m_, c_, g_ = sp.symbols("x v m c g")


def lagrangian():
    y = c_ * x_**2
    return m_ / 2 * (v_**2 + (2 * c_ * x_ * v_) ** 2) - m_ * g_ * y


def lagrange_equation():
    t = sp.Symbol("t")
    X = sp.Function("X")(t)
    L = lagrangian().subs({x_: X, v_: X.diff(t)})
    (eq,) = euler_equations(L, X, t)
    acc = sp.solve(eq.lhs, X.diff(t, 2))[0]
    return acc.subs(X.diff(t), v_).subs(X, x_)


_acc = sp.lambdify((x_, v_, c_, g_), lagrange_equation(), "math")


def acceleration_newton(x, v, *, curvature, gravity):
    tangent = np.array([1.0, 2 * curvature * x])
    known = np.array([0.0, 2 * curvature * v**2])  # a = x'' tangent + known
    return (np.array([0, -gravity]) - known) @ tangent / (tangent @ tangent)


def constraint_force(x, v, *, mass, curvature, gravity):
    ax = acceleration_newton(x, v, curvature=curvature, gravity=gravity)
    ay = 2 * curvature * (v**2 + x * ax)
    return mass * ax, mass * (ay + gravity)


def energy(x, v, *, mass, curvature, gravity):
    return mass * (v**2 * (1 + 4 * curvature**2 * x**2) / 2 + gravity * curvature * x**2)


def simulate(t, x, v, *, curvature, gravity):
    sol = solve_ivp(
        lambda _, z: [z[1], _acc(z[0], z[1], curvature, gravity)],
        (t[0], t[-1]), [x, v], t_eval=t, method="DOP853", rtol=1e-9, atol=1e-9,
    )
    return sol.y.T


def period(amplitude, *, curvature, gravity):
    k = 2 * curvature * amplitude
    return 4 / np.sqrt(2 * gravity * curvature) * ellipe(-(k**2))


def free_body_diagram(x, *, mass, curvature, gravity):
    at = [x, curvature * x * x]
    return [[at, [-2 * curvature * x, 1]], [at, [0, -mass * gravity]]]
