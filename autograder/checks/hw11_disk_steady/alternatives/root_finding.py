"""Show that unknowns by a root finder pass."""

import numpy as np
from scipy.optimize import brentq


def balance(lean, omega, spin, inward, normal, radius, inertia):
    A, C = inertia
    # e1 horizontal, e2 up along the disk, e3 the axle; the frame turns with omega z = omega (cos e2 - sin e3)
    frame = omega * np.array([0.0, np.cos(lean), -np.sin(lean)])
    H = np.array([A, A, C]) * np.array([0.0, frame[1], spin])
    force = np.array(
        [0.0, inward * np.sin(lean) + normal * np.cos(lean), inward * np.cos(lean) - normal * np.sin(lean)]
    )
    return (np.cross([0.0, -radius, 0.0], force) - np.cross(frame, H))[0]


def moment_residual(lean, precession, spin, inward, normal, *, mass, radius, inertia):
    return balance(lean, precession, spin, inward, normal, radius, inertia)


def contact_force(lean, precession, spin, *, mass, radius, gravity):
    speed = radius * spin
    return np.array([mass * precession * speed, mass * gravity])


def spin_by(inwards, lean, omega, radius, inertia, weight):
    def left(spin):
        return balance(lean, omega, spin, inwards(spin), weight, radius, inertia)

    width = 1.0
    while left(-width) * left(width) > 0:
        width *= 4
    return brentq(left, -width, width, xtol=1e-13, rtol=1e-14)


def rolling_spin(lean, precession, *, mass, radius, inertia, gravity):
    return spin_by(
        lambda s: mass * radius * s * precession, lean, precession, radius, inertia, mass * gravity
    )


def sliding_spin(lean, precession, *, mass, radius, inertia, gravity):
    return spin_by(lambda s: 0.0, lean, precession, radius, inertia, mass * gravity)


def rolling_track_radius(lean, precession, **disk):
    spin = rolling_spin(lean, precession, **disk)
    return disk["radius"] * spin / precession + disk["radius"] * np.sin(lean)


def sliding_track_radius(lean, *, radius):
    return np.sin(lean) * radius


def rolling_precession(lean, track_radius, *, mass, radius, inertia, gravity):
    def left(omega):
        spin = omega * (track_radius / radius - np.sin(lean))
        return balance(lean, omega, spin, mass * radius * omega * spin, mass * gravity, radius, inertia)

    if lean == 0 and track_radius == 0:
        raise ValueError("any Omega")
    if left(0.0) == 0.0:
        return 0.0
    largest = 1.0
    while left(0.0) * left(largest) > 0:
        largest *= 2
        if largest > 1e7:
            raise ValueError("no Omega")
    return brentq(left, 0.0, largest, xtol=1e-14, rtol=1e-14)


def common_precession(lean, *, mass, radius, inertia, gravity):
    lean = lean if abs(lean) > 1e-5 else 1e-5  # the limit, to 1e-10

    def left(omega):
        return balance(lean, omega, 0.0, 0.0, mass * gravity, radius, inertia)

    largest = 1.0
    while left(0.0) * left(largest) > 0:
        largest *= 2
    return brentq(left, 0.0, largest, xtol=1e-14, rtol=1e-14)


def settling_energy(lean, *, mass, radius, inertia, gravity):
    omega = common_precession(lean, mass=mass, radius=radius, inertia=inertia, gravity=gravity)
    return inertia[0] * (omega * np.cos(lean)) ** 2 / 2 + mass * gravity * radius * np.cos(lean)
