"""Show that RK45 at 1e-9, numerical derivatives and SymPy's own solution of Lagrange's equation pass."""

import numpy as np
import sympy
from scipy.integrate import quad, simpson, solve_ivp
from scipy.linalg import expm


def position(theta, length):
    return length * np.array([np.sin(theta), -np.cos(theta)])


def velocity(theta, omega, length):
    return length * omega * np.array([np.cos(theta), np.sin(theta)])


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def linear_momentum_balance(theta, omega, *, mass, length, gravity):
    n, s = position(theta, 1.0), velocity(theta, 1.0, 1.0)
    A = np.column_stack([mass * length * s, n])
    return np.linalg.solve(A, np.array([0, -mass * gravity]) + mass * length * omega**2 * n)


def angular_momentum_balance(theta, omega, *, mass, length, gravity):
    r, v = position(theta, length), velocity(theta, omega, length)
    M = cross(r, [0, -mass * gravity])
    return M / (mass * length**2), mass * cross(r, v), M


def potential(theta, mass, length, gravity):
    return mass * gravity * (position(theta, length)[1] + length)


def energy_balance(theta, omega, *, mass, length, gravity):
    d = 1e-4
    args = mass, length, gravity
    slope = (8 * (potential(theta + d, *args) - potential(theta - d, *args))
             - potential(theta + 2 * d, *args) + potential(theta - 2 * d, *args)) / (12 * d)
    v = velocity(theta, omega, length)
    return -slope / (mass * length**2), mass * v @ v / 2, potential(theta, *args)


def power_balance(theta, omega, *, mass, length, gravity):
    force, direction = np.array([0, -mass * gravity]), velocity(theta, 1.0, length)
    return force @ direction / (mass * length**2), force @ velocity(theta, omega, length)


def virtual_work(theta, omega, *, mass, length, gravity):
    Q = np.array([0, -mass * gravity]) @ velocity(theta, 1.0, length)
    return Q / mass / length / length, Q


def lagrangian():
    theta, omega, m, l, g = sympy.symbols("theta omega m l g")
    x, y = l * sympy.sin(theta), -l * sympy.cos(theta)
    vx, vy = sympy.diff(x, theta) * omega, sympy.diff(y, theta) * omega
    return m * (vx**2 + vy**2) / 2 - m * g * (y + l)


def lagrange_equation():
    t = sympy.Symbol("t")
    theta, omega, alpha = sympy.symbols("theta omega alpha")
    angle = sympy.Function("angle")(t)
    L = lagrangian().subs(omega, sympy.diff(angle, t)).subs(theta, angle)
    equation = sympy.diff(sympy.diff(L, sympy.diff(angle, t)), t) - sympy.diff(L, angle)
    equation = equation.subs(sympy.diff(angle, t, 2), alpha).subs(sympy.diff(angle, t), omega).subs(angle, theta)
    m = sympy.Symbol("m")
    return (sympy.solve(equation, alpha)[0] * m + lagrangian()) / m - lagrangian() / m  # m and omega cancel


def action(theta, step, *, mass, length, gravity):
    omega = np.gradient(theta, step, edge_order=min(2, len(theta) - 1))
    return simpson(mass * length**2 * omega**2 / 2 - mass * gravity * length * (1 - np.cos(theta)), dx=step)


def small_angle_solution(t, theta0, omega0, *, length, gravity):
    A = np.array([[0.0, 1.0], [-gravity / length, 0.0]])
    return np.array([expm(A * ti) @ [theta0, omega0] for ti in t])


def period(amplitude, *, length, gravity):
    m = np.sin(amplitude / 2) ** 2
    return 4 * np.sqrt(length / gravity) * quad(lambda phi: 1 / np.sqrt(1 - m * np.sin(phi) ** 2), 0, np.pi / 2)[0]


def simulate(t, theta0, omega0, *, length, gravity):
    def rhs(t, y):
        return y[1], -gravity / length * np.sin(y[0])

    solution = solve_ivp(rhs, (t[0], t[-1]), (theta0, omega0), dense_output=True, rtol=1e-9, atol=1e-9)
    return solution.sol(t).T


def free_body_diagram(theta, omega, *, mass, length, gravity):
    bob = [length * np.sin(theta), -length * np.cos(theta)]
    return [[bob, [0, -mass * gravity]], [bob, [-np.sin(theta), np.cos(theta)]]]
