"""Plain Python: the speed along the wire for a state, Runge-Kutta steps that are doubled to see the error."""

import math
from itertools import pairwise

from sympy import Rational, symbols


def lagrangian():
    x, v, m, c, g = symbols("x v m c g")
    return m * v**2 * (Rational(1, 2) + 2 * c**2 * x**2) - m * g * c * x**2


def lagrange_equation():
    x, v, c, g = symbols("x v c g")
    return -2 * c * x * (g + 2 * c * v**2) / (1 + 4 * c**2 * x**2)


def acceleration_newton(x, v, *, curvature, gravity):
    slope = 2 * curvature * x
    return -slope * (gravity + 2 * curvature * v * v) / (1 + slope * slope)


def constraint_force(x, v, *, mass, curvature, gravity):
    slope = 2 * curvature * x
    up = mass * (gravity + 2 * curvature * v * v) / (1 + slope * slope)
    return [-slope * up, up]


def energy(x, v, *, mass, curvature, gravity):
    return mass * ((v * v + (2 * curvature * x * v) ** 2) / 2 + gravity * curvature * x * x)


def simulate(t, x, v, *, curvature, gravity):
    def rates(x, w):
        slope = 2 * curvature * x
        length = math.hypot(1, slope)
        return w / length, -gravity * slope / length

    def step(x, w, h):
        a, b = rates(x, w)
        c, d = rates(x + h / 2 * a, w + h / 2 * b)
        e, f = rates(x + h / 2 * c, w + h / 2 * d)
        p, q = rates(x + h * e, w + h * f)
        return x + h / 6 * (a + 2 * c + 2 * e + p), w + h / 6 * (b + 2 * d + 2 * f + q)

    t = [float(one) for one in t]
    x, w = float(x), float(v) * math.hypot(1, 2 * curvature * float(x))
    fastest = math.sqrt(w * w + 2 * gravity * curvature * x * x)
    widest = abs(x) + (fastest / math.sqrt(2 * gravity * curvature) if gravity else fastest * (t[-1] - t[0]))
    rows, h = [[x, float(v)]], (t[1] - t[0]) / 10
    for now, end in pairwise(t):
        while now < end:
            last = now + h >= end
            size = end - now if last else h
            once, half = step(x, w, size), step(x, w, size / 2)
            twice = step(*half, size / 2)
            error = max(abs(twice[0] - once[0]) / widest, abs(twice[1] - once[1]) / fastest) if fastest else 0
            if error <= 1e-11:
                now = end if last else now + size
                x, w = (b + (b - a) / 15 for a, b in zip(once, twice, strict=True))
            grown = size * min(4, max(0.2, 0.9 * (1e-11 / (error + 1e-30)) ** 0.2))
            h = max(h, grown) if last and error <= 1e-11 else grown
        rows.append([x, w / math.hypot(1, 2 * curvature * x)])
    return rows


def period(amplitude, *, curvature, gravity):
    """The complete elliptic integral of the second kind by Gauss's mean."""
    steep = math.hypot(1, 2 * curvature * amplitude)
    a, b, c, weight, left = 1.0, 1 / steep, 2 * curvature * amplitude / steep, 0.5, 1.0
    while weight < 2**40 and abs(c) > 1e-17:
        left -= weight * c * c
        a, b, c, weight = (a + b) / 2, math.sqrt(a * b), (a - b) / 2, 2 * weight
    return 4 * steep * math.pi / (2 * a) * left / math.sqrt(2 * gravity * curvature)


def free_body_diagram(x, *, mass, curvature, gravity):
    bead, slope = (x, curvature * x**2), 2 * curvature * x
    size = (1 + slope**2) ** 0.5
    wire = (bead, (slope / size, -1 / size))  # it may push or pull
    return [wire, (bead, (0.0, -1.0))] if gravity else [wire]
