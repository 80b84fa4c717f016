"""Right: formulas in units of m a^2, the common precession by bisection of the rolling spin."""
import math
from math import cos, sin, tan


def rolling_spin(lean, precession, *, mass, radius, inertia, gravity):
    A, C = inertia
    k = mass * radius**2
    return (mass * gravity * radius * tan(lean) / precession - A * precession * sin(lean)) / (C + k)


def rolling_track_radius(lean, precession, *, mass, radius, inertia, gravity):
    s = rolling_spin(lean, precession, mass=mass, radius=radius, inertia=inertia, gravity=gravity)
    return radius * (s / precession + sin(lean))


def sliding_spin(lean, precession, *, mass, radius, inertia, gravity):
    A, C = inertia
    return (mass * gravity * radius * tan(lean) / precession - A * precession * sin(lean)) / C


def sliding_track_radius(lean, *, radius):
    return radius * sin(lean)


def contact_force(lean, precession, spin, *, mass, radius, gravity):
    return (mass * radius * spin * precession, mass * gravity)


def moment_residual(lean, precession, spin, inward, normal, *, mass, radius, inertia):
    A, C = inertia
    moment = normal * radius * sin(lean) - inward * radius * cos(lean)
    rate = precession * cos(lean) * (C * spin + A * precession * sin(lean))
    return moment - rate


def rolling_precession(lean, track_radius, *, mass, radius, inertia, gravity):
    from numpy import sqrt
    A, C = inertia[0] / (mass * radius**2), inertia[1] / (mass * radius**2)
    d = (1 + C) * track_radius - (1 + C - A) * radius * sin(lean)
    if abs(d) < 1e-13 * radius:
        raise ValueError("none or all")
    w2 = gravity * tan(lean) / d
    if w2 < 0:
        raise ValueError("none")
    return sqrt(w2)


def common_precession(lean, **body):
    "the precession at which the rolling spin vanishes, by bisection"
    lean = lean or 1e-7
    lo, hi = 1e-6, 1e6
    sign = 1 if lean > 0 else -1
    for _ in range(200):
        mid = math.sqrt(lo * hi)
        if sign * rolling_spin(lean, mid, **body) > 0:
            lo = mid
        else:
            hi = mid
    return mid


def settling_energy(lean, *, mass, radius, inertia, gravity):
    if gravity == 0:
        return 0.0
    w = common_precession(lean, mass=mass, radius=radius, inertia=inertia, gravity=gravity)
    return inertia[0] * (w * cos(lean)) ** 2 / 2 + mass * gravity * radius * cos(lean)
