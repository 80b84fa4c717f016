"""Right functions of hw13 that share helpers; diagnosis tries mistakes in these, which change several functions."""

import math


def acceleration(*state, **cylinder):
    return _solved(*state, **cylinder)[0]


def contact_force(*state, **cylinder):
    return tuple(_solved(*state, **cylinder)[1:])


def contact_inertia(phi, *, mass, radius, offset, inertia):
    x, y = _arm(phi, radius, offset)
    return inertia + mass * (x**2 + y**2)


def naive_contact_acceleration(phi, *, mass, radius, offset, inertia, slope, gravity):
    x, y = _arm(phi, radius, offset)
    moment = mass * gravity * (x * math.cos(slope) + y * math.sin(slope))
    return moment / contact_inertia(phi, mass=mass, radius=radius, offset=offset, inertia=inertia)


def missing_moment(phi, phi_dot, *, mass, radius, offset):
    x, _ = _arm(phi, radius, offset)
    return -x * mass * radius * phi_dot**2


def energy(phi, phi_dot, *, mass, radius, offset, inertia, slope, gravity):
    x, y = _arm(phi, radius, offset)
    kinetic = (inertia + mass * (x**2 + y**2)) * phi_dot**2 / 2
    return kinetic + mass * gravity * ((y - radius) * math.cos(slope) - (radius * phi + x) * math.sin(slope))


def _solved(phi, phi_dot, *, mass, radius, offset, inertia, slope, gravity):
    """Compute phi'' by the moment about G of along and normal, which momentum balances of G give; it can be traced."""
    x, y = _arm(phi, radius, offset)
    along = mass * gravity * math.sin(slope) + mass * x * phi_dot**2
    normal = mass * gravity * math.cos(slope) + mass * (radius - y) * phi_dot**2
    acceleration = (y * along + x * normal) / (inertia + mass * (x**2 + y**2))
    return acceleration, mass * y * acceleration - along, normal - mass * x * acceleration


def _arm(phi, radius, offset):
    """Return G from the contact."""
    return -offset * math.sin(phi), radius - offset * math.cos(phi)
