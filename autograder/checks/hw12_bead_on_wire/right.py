"""What is right in hw12, by another route than the solution's: bend and length of the wire, elliptic integrals."""

import math

import numpy as np
from scipy.special import ellipe, ellipeinc


def acceleration_newton(x, v, curvature, gravity):
    """x'' from the acceleration along the wire, which is that of gravity, and the turning of the tangent."""
    angle = math.atan(2 * curvature * x)  # of the wire
    speed = v / math.cos(angle)
    turning = 2 * curvature * math.cos(angle) ** 3 * speed  # rate of the angle: bend of the wire times speed
    return -gravity * math.sin(angle) * math.cos(angle) - speed * math.sin(angle) * turning


def constraint_force(x, v, mass, curvature, gravity):
    """Along the normal: mass times speed^2 over the radius of curvature, and the weight's share."""
    angle = math.atan(2 * curvature * x)
    bend = 2 * curvature * math.cos(angle) ** 3
    size = mass * (bend * (v / math.cos(angle)) ** 2 + gravity * math.cos(angle))
    return size * np.array([-math.sin(angle), math.cos(angle)])


def kinetic(x, v, mass, curvature):
    velocity = np.array([v, 2 * curvature * x * v])
    return mass * velocity @ velocity / 2


def energy(x, v, mass, curvature, gravity):
    return kinetic(x, v, mass, curvature) + mass * gravity * curvature * x**2


def lagrangian(x, v, m, c, g):
    return 2 * kinetic(x, v, m, c) - energy(x, v, m, c, g)


def lagrange_equation(x, v, c, g):
    return acceleration_newton(x, v, c, g)


def amplitude(x, v, curvature, gravity):
    return math.sqrt(energy(x, v, 1.0, curvature, gravity) / (gravity * curvature))


def period(amplitude, curvature, gravity):
    """By Legendre's complete integral of the second kind."""
    return 4 * ellipe(-((2 * curvature * amplitude) ** 2)) / math.sqrt(2 * gravity * curvature)


def simulate(t, x, v, curvature, gravity):
    """(n, 2) states: x = A sin phi, where Legendre's E(phi, -(2 c A)^2) grows evenly."""
    if gravity == 0:
        return _weightless(t - t[0], x, v, curvature)
    size, rate = amplitude(x, v, curvature, gravity), math.sqrt(2 * gravity * curvature)
    m = -((2 * curvature * size) ** 2)
    speed = v * math.hypot(1, 2 * curvature * x)
    grown = ellipeinc(math.atan2(x, speed / rate), m) + rate * (t - t[0])
    quarter = np.floor(grown / ellipe(m)) * math.pi / 2
    phi = _inverse(lambda phi: ellipeinc(phi, m), grown, quarter, quarter + math.pi / 2)
    return size * np.column_stack([np.sin(phi), rate * np.cos(phi) / np.sqrt(1 - m * np.sin(phi) ** 2)])


def _weightless(t, x, v, curvature):
    """The length of wire passed grows evenly."""
    slope = 2 * curvature * x
    speed = v * math.hypot(1, slope)
    u = slope + 2 * curvature * np.outer([-1, 1], abs(speed * t))
    u = _inverse(_arc, _arc(slope) + 2 * curvature * speed * t, *u)
    return np.column_stack([u / (2 * curvature), speed / np.sqrt(1 + u**2)])


def _arc(u):
    """Length of the parabola y = x^2/2 up to x = u."""
    return (u * np.sqrt(1 + u**2) + np.arcsinh(u)) / 2


def _inverse(function, values, low, high):
    """Where an increasing function takes these values between low and high, by bisection."""
    for _ in range(60):
        middle = (low + high) / 2
        above = function(middle) > values
        low, high = np.where(above, low, middle), np.where(above, middle, high)
    return (low + high) / 2


def energy_of_rows(rows, curvature, gravity):
    """Of a bead of 1 kg, along a motion."""
    x, v = rows.T
    return (1 + (2 * curvature * x) ** 2) * v**2 / 2 + gravity * curvature * x**2
