"""Right: a period by Gauss's mean, symbols with assumptions, numpy.gradient in the action, Runge and Kutta's steps by hand."""
import numpy as np
import sympy as sp
from scipy.integrate import solve_ivp
from scipy.special import ellipkm1


def linear_momentum_balance(theta, omega, *, mass, length, gravity):
    er = np.array([np.sin(theta), -np.cos(theta)])
    et = np.array([np.cos(theta), np.sin(theta)])
    weight = np.array([0, -mass * gravity])
    alpha = weight @ et / (mass * length)
    tension = mass * length * omega**2 + weight @ er
    return alpha, tension


def angular_momentum_balance(theta, omega, *, mass, length, gravity):
    H = mass * length**2 * omega
    M = -mass * gravity * length * np.sin(theta)
    return [M / (mass * length**2), H, M]


def energy_balance(theta, omega, *, mass, length, gravity):
    # dE/dt = omega (m l^2 alpha + m g l sin) = 0 at every omega near this one
    return (
        -gravity / length * np.sin(theta),
        mass * (length * omega) ** 2 / 2,
        2 * mass * gravity * length * np.sin(theta / 2) ** 2,
    )


def power_balance(theta, omega, *, mass, length, gravity):
    vy = length * omega * np.sin(theta)
    return np.array([-gravity * np.sin(theta) / length, -mass * gravity * vy])


def virtual_work(theta, omega, *, mass, length, gravity):
    Q = -mass * gravity * length * np.sin(theta)
    return Q / mass / length**2, Q


def action(theta, step, *, mass, length, gravity):
    w = np.gradient(theta, step)
    return np.trapezoid(mass * length**2 * w**2 / 2 - mass * gravity * length * (1 - np.cos(theta)), dx=step)


def period(amplitude, *, length, gravity):
    a, b = 1.0, np.cos(amplitude / 2)
    for _ in range(40):
        a, b = (a + b) / 2, np.sqrt(a * b)
    return 2 * np.pi * np.sqrt(length / gravity) / a


def lagrangian():
    theta, omega = sp.symbols("theta omega", real=True)
    m, l, g = sp.symbols("m l g", positive=True)
    return 0.5 * m * l**2 * omega**2 - m * g * l * (1 - sp.cos(theta))


def lagrange_equation():
    t = sp.Symbol("t")
    m, l, g = sp.symbols("m l g", positive=True)
    th, om = sp.symbols("theta omega", real=True)
    q = sp.Function("q")(t)
    L = lagrangian()
    eq = L.diff(om).subs({om: q.diff(t), th: q}).diff(t) - L.diff(th).subs(th, q)
    return sp.solve(eq, q.diff(t, 2))[0].subs(q, th)


def small_angle_solution(t, theta0, omega0, *, length, gravity):
    w = (gravity / length) ** 0.5
    out = []
    for s in t:
        out.append([theta0 * np.cos(w * s) + omega0 * s * np.sinc(w * s / np.pi), omega0 * np.cos(w * s) - theta0 * w * np.sin(w * s)])
    return out


def simulate(t, theta0, omega0, *, length, gravity):
    "own RK4 with many steps"
    f = lambda z: np.array([z[1], -gravity / length * np.sin(z[0])])
    z, rows = np.array([theta0, omega0], float), [[theta0, omega0]]
    rate = max((gravity / length) ** 0.5, abs(omega0), 1e-3)
    for a, b in zip(t[:-1], t[1:]):
        n = int(np.ceil((b - a) * rate * 150)) + 1
        h = (b - a) / n
        for _ in range(n):
            k1 = f(z); k2 = f(z + h / 2 * k1); k3 = f(z + h / 2 * k2); k4 = f(z + h * k3)
            z = z + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        rows.append(list(z))
    return rows


def free_body_diagram(theta, omega, *, mass, length, gravity):
    bob = [length * np.sin(theta), -length * np.cos(theta)]
    return [[bob, [0, -mass * gravity]], [bob, [-np.sin(theta), np.cos(theta)]]]
