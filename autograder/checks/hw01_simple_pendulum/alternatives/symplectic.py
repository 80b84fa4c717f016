"""Right: a symplectic method of fourth order with small fixed steps, the arithmetic-geometric mean, floats alone."""

import math

import numpy as np
from sympy import Rational, Symbol, cos, sin

CUBE = 2 ** (1 / 3)
KICKS = (1 / (2 - CUBE), -CUBE / (2 - CUBE), 1 / (2 - CUBE))  # Yoshida 1990


def linear_momentum_balance(theta, omega, *, mass, length, gravity):
    return np.float64(-gravity / length * math.sin(theta)), np.float64(mass * (length * omega**2 + gravity * math.cos(theta)))


def angular_momentum_balance(theta, omega, *, mass, length, gravity):
    H, M = mass * length**2 * omega, -mass * gravity * length * math.sin(theta)
    return np.array([M / mass / length**2, H, M])


def energy_balance(theta, omega, *, mass, length, gravity):
    return -gravity / length * math.sin(theta), mass * length**2 * omega**2 / 2, 2 * mass * gravity * length * math.sin(theta / 2) ** 2


def power_balance(theta, omega, *, mass, length, gravity):
    return -gravity / length * math.sin(theta), mass * gravity * length * omega * math.sin(-theta)


def virtual_work(theta, omega, *, mass, length, gravity):
    return -gravity / length * math.sin(theta), mass * gravity * length * math.sin(-theta)


def lagrangian():
    theta, omega, m, l, g = map(Symbol, ("theta", "omega", "m", "l", "g"))
    return Rational(1, 2) * m * (l * omega) ** 2 * (sin(theta) ** 2 + cos(theta) ** 2) + m * g * l * cos(theta) - m * g * l


def lagrange_equation():
    return -Symbol("g") * sin(Symbol("theta")) / Symbol("l")


def action(theta, step, *, mass, length, gravity):
    slopes = np.diff(theta) / step
    middle = 0.5 * (theta[1:] + theta[:-1])
    return float(np.sum(mass * length**2 * slopes**2 / 2 - mass * gravity * length * (1 - np.cos(middle))) * step)


def small_angle_solution(t, theta0, omega0, *, length, gravity):
    k = math.sqrt(gravity / length)
    s = np.sin(k * t) / k if k else np.asarray(t)
    return np.transpose([theta0 * np.cos(k * t) + omega0 * s, omega0 * np.cos(k * t) - k * k * theta0 * s])


def period(amplitude, *, length, gravity):
    a, b = 1.0, math.cos(amplitude / 2)
    for _ in range(12):
        a, b = (a + b) / 2, math.sqrt(a * b)
    return 2 * math.pi / a * math.sqrt(length / gravity)


def simulate(t, theta0, omega0, *, length, gravity):
    ratio = gravity / length
    longest = 0.01 / max(math.sqrt(ratio), 0.1)
    theta, omega = theta0, omega0
    rows = [(theta, omega)]
    for span in np.diff(t):
        steps = math.ceil(span / longest)
        h = span / steps
        for _ in range(steps):
            for w in KICKS:
                theta += w * h / 2 * omega
                omega -= w * h * ratio * math.sin(theta)
                theta += w * h / 2 * omega
        rows.append((theta, omega))
    return rows


def free_body_diagram(theta, omega, *, mass, length, gravity):
    s, c = np.sin(theta), np.cos(theta)
    bob = (length * s, -length * c)
    forces = [(bob, bob)]  # the rod
    if gravity:
        forces.append((bob, (0.0, -gravity)))
    return forces
