"""Right: formulas as in a notebook, lists for results, DOP853, trapezoidal action, symbols that are known to be real."""

import numpy as np
import sympy as sp
from scipy.integrate import solve_ivp, trapezoid
from scipy.special import ellipk


def linear_momentum_balance(theta, omega, *, mass, length, gravity):
    return [-gravity * np.sin(theta) / length, mass * (gravity * np.cos(theta) + length * omega**2)]


def angular_momentum_balance(theta, omega, *, mass, length, gravity):
    alpha = -gravity * np.sin(theta) / length
    return [alpha, mass * omega * length * length, mass * length**2 * alpha]


def energy_balance(theta, omega, *, mass, length, gravity):
    kinetic = 0.5 * mass * (length * omega) ** 2
    potential = mass * gravity * length * (1 - np.cos(theta))
    return [-gravity * np.sin(theta) / length, kinetic, potential]


def power_balance(theta, omega, *, mass, length, gravity):
    return [-gravity * np.sin(theta) / length, -mass * gravity * length * omega * np.sin(theta)]


def virtual_work(theta, omega, *, mass, length, gravity):
    return [-gravity * np.sin(theta) / length, -mass * gravity * length * np.sin(theta)]


def lagrangian():
    theta, omega = sp.symbols("theta omega", real=True)
    m, l, g = sp.symbols("m l g", positive=True)
    return sp.expand(m * l**2 * omega**2 / 2 - 2 * m * g * l * sp.sin(theta / 2) ** 2)


def lagrange_equation():
    theta, omega = sp.symbols("theta omega", real=True)
    m, l = sp.symbols("m l", positive=True)
    return sp.diff(lagrangian(), theta) / (m * l**2)


def action(theta, step, *, mass, length, gravity):
    omega = np.gradient(theta, step)
    return trapezoid(0.5 * mass * length**2 * omega**2 - mass * gravity * length * (1 - np.cos(theta)), dx=step)


def small_angle_solution(t, theta0, omega0, *, length, gravity):
    k = np.sqrt(gravity / length)
    sinc = t * np.sinc(k * t / np.pi)
    return [[a, b] for a, b in zip(theta0 * np.cos(k * t) + omega0 * sinc,
                                   omega0 * np.cos(k * t) - theta0 * k * k * sinc)]


def period(amplitude, *, length, gravity):
    return 4 * np.sqrt(length / gravity) * ellipk(np.sin(amplitude / 2) ** 2)


def simulate(t, theta0, omega0, *, length, gravity):
    def rhs(t, y):
        return [y[1], -gravity / length * np.sin(y[0])]

    return solve_ivp(rhs, (t[0], t[-1]), [theta0, omega0], t_eval=t, method="DOP853", rtol=1e-9, atol=1e-9).y.T


def free_body_diagram(theta, omega, *, mass, length, gravity):
    s, c = np.sin(theta), np.cos(theta)
    bob = (length * s, -length * c)
    forces = [(bob, bob)]  # the rod
    if gravity:
        forces.append((bob, (0.0, -gravity)))
    return forces
