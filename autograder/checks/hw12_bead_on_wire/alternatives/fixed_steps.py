"""Right: Runge and Kutta's classical method with many fixed steps, along the wire; the period by its own mean values."""

import math

import numpy as np
from sympy import Symbol, diff


def lagrangian():
    x, v, m, c, g = map(Symbol, "xvmcg")
    y = c * x * x
    return m * v * v * (1 + diff(y, x) ** 2) / 2 - m * g * y


def lagrange_equation():
    x, v, c, g = map(Symbol, "xvcg")
    y = c * x * x
    return -diff(y, x) * (g + diff(y, x, 2) * v**2) / (1 + diff(y, x) ** 2)


def acceleration_newton(x, v, *, curvature, gravity):
    slope, bend = 2 * curvature * x, 2 * curvature
    return np.float64(-slope * (gravity + bend * v * v) / (1 + slope * slope))


def constraint_force(x, v, *, mass, curvature, gravity):
    slope, bend = 2 * curvature * x, 2 * curvature
    N = mass * (gravity + bend * v * v) / (1 + slope * slope)
    return np.array([-slope, 1.0]) * N


def energy(x, v, *, mass, curvature, gravity):
    slope = 2 * curvature * x
    return np.array(mass * (v * v * (1 + slope * slope) / 2 + gravity * x * slope / 2))


def simulate(t, x, v, *, curvature, gravity):
    def rates(x, w):
        slope = 2 * curvature * x
        stretch = math.sqrt(1 + slope * slope)
        return w / stretch, -gravity * slope / stretch

    w = v * math.hypot(1, 2 * curvature * x)
    longest = 0.01 / math.sqrt(2 * curvature * max(gravity, abs(w) * 0.1, 1.0))
    rows = [(x, v)]
    for span in np.diff(t):
        steps = math.ceil(span / longest)
        h = span / steps
        for _ in range(steps):
            a, b = rates(x, w)
            c, d = rates(x + h / 2 * a, w + h / 2 * b)
            e, f = rates(x + h / 2 * c, w + h / 2 * d)
            p, q = rates(x + h * e, w + h * f)
            x, w = x + h / 6 * (a + 2 * c + 2 * e + p), w + h / 6 * (b + 2 * d + 2 * f + q)
        rows.append((x, w / math.hypot(1, 2 * curvature * x)))
    return rows


def period(amplitude, *, curvature, gravity):
    """The trapezoidal rule converges geometrically for a periodic integrand; 20000 points reach amplitudes of 100/c."""
    phi = np.linspace(0, np.pi, 20001)[:-1]
    return 2 * np.pi * np.mean(np.hypot(1, 2 * curvature * amplitude * np.sin(phi))) / np.sqrt(2 * gravity * curvature)


def free_body_diagram(x, *, mass, curvature, gravity):
    bead, slope = (x, curvature * x**2), 2 * curvature * x
    size = (1 + slope**2) ** 0.5
    wire = (bead, (slope / size, -1 / size))  # it may push or pull
    return [wire, (bead, (0.0, -1.0))] if gravity else [wire]
