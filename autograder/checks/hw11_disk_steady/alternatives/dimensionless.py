"""Show that the textbook's formulas in A/(m a^2) and C/(m a^2) pass, in plain Python."""

from math import cos, sin, sqrt, tan


def shape(mass, radius, inertia):
    return [moment / (mass * radius * radius) for moment in inertia]


def rolling_precession(lean, track_radius, *, mass, radius, inertia, gravity):
    k, n = shape(mass, radius, inertia)
    bracket = (1 + n) * track_radius - (1 + n - k) * radius * sin(lean)
    if bracket == 0:
        raise ValueError
    square = gravity * tan(lean) / bracket
    if square < 0:
        raise ValueError
    return sqrt(square)


def rolling_track_radius(lean, precession, *, mass, radius, inertia, gravity):
    k, n = shape(mass, radius, inertia)
    return (gravity * tan(lean) / precession**2 + (1 + n - k) * radius * sin(lean)) / (1 + n)


def rolling_spin(lean, precession, **disk):
    R = rolling_track_radius(lean, precession, **disk)
    return precession * (R / disk["radius"] - sin(lean))


def sliding_spin(lean, precession, *, mass, radius, inertia, gravity):
    k, n = shape(mass, radius, inertia)
    return (gravity * tan(lean) / (radius * precession) - k * precession * sin(lean)) / n


def sliding_track_radius(lean, *, radius):
    return radius * sin(lean)


def common_precession(lean, *, mass, radius, inertia, gravity):
    k, _ = shape(mass, radius, inertia)
    return sqrt(gravity / (k * radius * cos(lean)))


def contact_force(lean, precession, spin, *, mass, radius, gravity):
    if precession == 0:
        return [0, mass * gravity]
    R = radius * (spin / precession + sin(lean))
    return [mass * precession**2 * (R - radius * sin(lean)), mass * gravity]


def moment_residual(lean, precession, spin, inward, normal, *, mass, radius, inertia):
    A, C = inertia
    gyroscopic = precession * cos(lean) * (C * spin + A * precession * sin(lean))
    return normal * radius * sin(lean) - inward * radius * cos(lean) - gyroscopic


def settling_energy(lean, *, mass, radius, inertia, gravity):
    return 3 * mass * gravity * radius * cos(lean) / 2
