"""Plain Python: the plane as complex numbers, Gauss's mean for the period, the power series of the motion."""

import cmath
import math

from sympy import Rational, cos, diff, symbols

TERMS = 25  # of the series; a step is at most a quarter of its radius, 4^-25 = 1e-15


def place(theta, length):
    """x + i y; its derivative by theta is 1j times it."""
    return -1j * length * cmath.exp(1j * theta)


def dot(a, b):
    return (a.conjugate() * b).real


def linear_momentum_balance(theta, omega, *, mass, length, gravity):
    """Newton's law for x and y, over exp(i theta): the tension is real part, the rest has none of it."""
    outwards = -1j * cmath.exp(1j * theta)
    total = (-1j * mass * gravity) / outwards  # along the rod, and across it
    return total.imag / (mass * length), total.real + mass * length * omega * omega


def angular_momentum_balance(theta, omega, *, mass, length, gravity):
    r = place(theta, length)
    inertia, moment = mass * dot(r, r), -mass * gravity * r.real
    return moment / inertia, inertia * omega, moment


def energy_balance(theta, omega, *, mass, length, gravity):
    height = 2 * length * math.sin(theta / 2) ** 2
    # T + V stays: along theta, d(l^2 omega^2 / 2) = -g dh
    return -gravity * math.sin(theta) / length, mass * (length * omega) ** 2 / 2, mass * gravity * height


def power_balance(theta, omega, *, mass, length, gravity):
    per_omega = dot(-1j * mass * gravity, 1j * place(theta, length))
    return per_omega / (mass * length * length), per_omega * omega


def virtual_work(theta, omega, *, mass, length, gravity):
    force = (-1j * mass * gravity * (1j * place(theta, length)).conjugate()).real
    return force / mass / length**2, force


def lagrangian():
    theta, omega, m, length, g = symbols("theta omega m l g")
    return Rational(1, 2) * m * (length * omega) ** 2 - m * g * length * (1 - cos(theta))


def lagrange_equation():
    theta, omega = symbols("theta omega")
    L = lagrangian()
    return (diff(L, theta) - omega * diff(L, omega, theta)) / diff(L, omega, 2)


def action(theta, step, *, mass, length, gravity):
    """Between samples the angle changes evenly; the potential by trapezoids."""
    path = [float(one) for one in theta]
    kinetic = math.fsum((b - a) ** 2 for a, b in zip(path, path[1:], strict=False)) / (2 * step)
    depths = [2 * math.sin(one / 2) ** 2 for one in path]
    potential = step * (math.fsum(depths) - (depths[0] + depths[-1]) / 2)
    return mass * length * (length * kinetic - gravity * potential)


def small_angle_solution(t, theta0, omega0, *, length, gravity):
    k = math.sqrt(gravity / length)
    if k == 0:
        return [(theta0 + omega0 * one, omega0) for one in t]
    z = theta0 + omega0 / (1j * k)
    turned = [z * cmath.exp(1j * k * one) for one in t]
    return [(one.real, -k * one.imag) for one in turned]


def period(amplitude, *, length, gravity):
    a, b = 1.0, math.sin((math.pi - amplitude) / 2)
    while abs(a - b) > 1e-15 * a:
        a, b = (a + b) / 2, math.sqrt(a * b)
    return 2 * math.pi / a * math.sqrt(length / gravity)


def series(theta, omega, ratio):
    """The coefficients of theta(t); those of its sine and cosine come from each other."""
    angle, sine, cosine = [theta, omega], [math.sin(theta)], [math.cos(theta)]
    for n in range(1, TERMS):
        rate = [j * angle[j] for j in range(1, n + 1)]
        sine.append(sum(a * b for a, b in zip(rate, reversed(cosine), strict=True)) / n)
        cosine.append(-sum(a * b for a, b in zip(rate, reversed(sine[:n]), strict=True)) / n)
        angle.append(-ratio * sine[n - 1] / (n * (n + 1)))
    return angle


def value(angle, h):
    """theta and omega a time h later."""
    theta = omega = 0.0
    for n in range(len(angle) - 1, 0, -1):
        theta, omega = angle[n] + h * theta, n * angle[n] + h * omega
    return angle[0] + h * theta, omega


def simulate(t, theta0, omega0, *, length, gravity):
    """The steps are the series' own; rows are read off it. No motion has a singularity nearer than 3/fastest."""
    now, state, rows = float(t[0]), (float(theta0), float(omega0)), []
    fastest = math.sqrt(omega0**2 + 4 * gravity / length)
    step = 0.75 / fastest if fastest else math.inf
    angle = series(*state, gravity / length)
    for one in t:
        while one - now > step:
            state, now = value(angle, step), now + step
            angle = series(*state, gravity / length)
        rows.append(value(angle, float(one) - now))
    rows[0] = (float(theta0), float(omega0))
    return rows


def free_body_diagram(theta, omega, *, mass, length, gravity):
    bob = [length * math.sin(theta), -length * math.cos(theta)]
    return [[bob, [0, -mass * gravity]], [bob, [-math.sin(theta), math.cos(theta)]]]
