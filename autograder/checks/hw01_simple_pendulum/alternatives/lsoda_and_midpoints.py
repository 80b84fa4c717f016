"""Show that LSODA passes, a sum over chords for the action, and a diagram of lines without sizes."""

import math

from scipy.integrate import odeint, quad
import sympy


def alpha(theta, length, gravity):
    return -(gravity / length) * math.sin(theta)


def linear_momentum_balance(theta, omega, *, mass, length, gravity):
    return alpha(theta, length, gravity), mass * omega**2 * length + mass * gravity * math.cos(theta)


def angular_momentum_balance(theta, omega, *, mass, length, gravity):
    I = mass * length**2
    return alpha(theta, length, gravity), I * omega, I * alpha(theta, length, gravity)


def energy_balance(theta, omega, *, mass, length, gravity):
    return alpha(theta, length, gravity), mass * length**2 * omega**2 / 2, mass * gravity * (length - length * math.cos(theta))


def power_balance(theta, omega, *, mass, length, gravity):
    return alpha(theta, length, gravity), mass * length**2 * alpha(theta, length, gravity) * omega


def virtual_work(theta, omega, *, mass, length, gravity):
    return alpha(theta, length, gravity), mass * length**2 * alpha(theta, length, gravity)


def lagrangian():
    theta, omega, m, l, g = sympy.symbols("theta omega m l g")
    return m * l * (l * omega**2 + 2 * g * sympy.cos(theta)) / 2 - m * l * g


def lagrange_equation():
    theta, l, g = sympy.symbols("theta l g")
    return -2 * g * sympy.sin(theta / 2) * sympy.cos(theta / 2) / l


def action(theta, step, *, mass, length, gravity):
    total = 0.0
    for a, b in zip(theta[:-1], theta[1:]):
        kinetic = mass * (length * (b - a) / step) ** 2 / 2
        total += step * (kinetic - mass * gravity * length * (2 - math.cos(a) - math.cos(b)) / 2)
    return total


def small_angle_solution(t, theta0, omega0, *, length, gravity):
    if gravity == 0:
        return [(theta0 + omega0 * s, omega0) for s in t]
    k = math.sqrt(gravity / length)
    size, phase = math.hypot(theta0, omega0 / k), math.atan2(-omega0 / k, theta0)
    return [(size * math.cos(k * s + phase), -size * k * math.sin(k * s + phase)) for s in t]


def period(amplitude, *, length, gravity):
    def integrand(q):  # theta = amplitude - q^2 takes the root out of the denominator
        return q / math.sqrt(math.sin(amplitude - q * q / 2) * math.sin(q * q / 2))

    return 4 * math.sqrt(length / gravity) * quad(integrand, 0, math.sqrt(amplitude), limit=200)[0]


def simulate(t, theta0, omega0, *, length, gravity):
    return odeint(lambda y, t: (y[1], alpha(y[0], length, gravity)), (theta0, omega0), t, rtol=1e-9, atol=1e-9, mxstep=5000)


def free_body_diagram(theta, omega, *, mass, length, gravity):
    s, c = math.sin(theta), math.cos(theta)
    bob = (length * s, -length * c)
    forces = [(bob, bob)]  # the rod
    if gravity:
        forces.append((bob, (0.0, -gravity)))
    return forces
