"""Show that moments about the centre and about the material contact pass, complex numbers, LSODA."""

import cmath
import math

import numpy as np
from scipy.integrate import odeint


def arm(phi, radius, offset):
    """From the contact to G."""
    return 1j * radius - 1j * offset * cmath.exp(-1j * phi)


def cross(a, b):
    return (a.conjugate() * b).imag


def contact_inertia(phi, *, mass, radius, offset, inertia):
    return inertia + mass * abs(arm(phi, radius, offset)) ** 2


def naive_contact_acceleration(phi, *, mass, radius, offset, inertia, slope, gravity):
    weight = mass * gravity * -1j * cmath.exp(1j * slope)
    moment = -cross(arm(phi, radius, offset), weight)
    return moment / contact_inertia(phi, mass=mass, radius=radius, offset=offset, inertia=inertia)


def missing_moment(phi, phi_dot, *, mass, radius, offset):
    upward = 1j * radius * phi_dot**2  # acceleration of the material point at the contact
    return -cross(arm(phi, radius, offset), mass * upward)


def acceleration(phi, phi_dot, *, mass, radius, offset, inertia, slope, gravity):
    body = dict(mass=mass, radius=radius, offset=offset)
    lacking = missing_moment(phi, phi_dot, **body) / contact_inertia(phi, inertia=inertia, **body)
    return naive_contact_acceleration(phi, inertia=inertia, slope=slope, gravity=gravity, **body) - lacking


def contact_force(phi, phi_dot, *, mass, radius, offset, inertia, slope, gravity):
    a = acceleration(phi, phi_dot, mass=mass, radius=radius, offset=offset, inertia=inertia, slope=slope, gravity=gravity)
    of_G = radius * a + 1j * offset * (1j * a + phi_dot**2) * cmath.exp(-1j * phi)
    force = mass * of_G + mass * gravity * 1j * cmath.exp(1j * slope)
    return np.array([force.real, force.imag])


def energy(phi, phi_dot, *, mass, radius, offset, inertia, slope, gravity):
    G = radius * phi - 1j * offset * cmath.exp(-1j * phi)
    height = (G * cmath.exp(-1j * slope)).imag
    turning = contact_inertia(phi, mass=mass, radius=radius, offset=offset, inertia=inertia)
    return turning * phi_dot**2 / 2 + mass * gravity * height


def simulate(t, phi, phi_dot, **cylinder):
    return odeint(lambda y, s: [y[1], acceleration(y[0], y[1], **cylinder)], [phi, phi_dot], t, rtol=1e-9, atol=1e-9)


def free_body_diagram(phi, *, mass, radius, offset, slope, gravity):
    contact = (0.0, -radius)
    down = (np.sin(slope), -np.cos(slope))
    heavy = (-offset * np.sin(phi), -offset * np.cos(phi))
    return [(contact, (-1.0, 0.0)), (contact, (0.0, mass)), (heavy, down)]
