"""Right functions of hw13 by the velocity of G for phi' = 1; diagnosis tries mistakes in its parts, too."""

import numpy as np


def acceleration(phi, phi_dot, *, mass, radius, offset, inertia, slope, gravity):
    force = _weight(mass, slope, gravity) - mass * _centripetal(phi, phi_dot, offset)
    about_contact = contact_inertia(phi, mass=mass, radius=radius, offset=offset, inertia=inertia)
    return _velocity(phi, radius, offset) @ force / about_contact


def contact_inertia(phi, *, mass, radius, offset, inertia):
    velocity = _velocity(phi, radius, offset)
    return inertia + mass * velocity @ velocity


def naive_contact_acceleration(phi, *, mass, slope, gravity, **cylinder):
    moment = _velocity(phi, cylinder["radius"], cylinder["offset"]) @ _weight(mass, slope, gravity)
    return moment / contact_inertia(phi, mass=mass, **cylinder)


def missing_moment(phi, phi_dot, *, mass, radius, offset):
    return mass * _velocity(phi, radius, offset) @ _centripetal(phi, phi_dot, offset)


def contact_force(phi, phi_dot, *, mass, slope, gravity, **cylinder):
    acceleration_of_turning = acceleration(phi, phi_dot, mass=mass, slope=slope, gravity=gravity, **cylinder)
    tangential = _velocity(phi, cylinder["radius"], cylinder["offset"]) * acceleration_of_turning
    force = mass * (tangential + _centripetal(phi, phi_dot, cylinder["offset"])) - _weight(mass, slope, gravity)
    return tuple(force)


def energy(phi, phi_dot, *, mass, slope, gravity, **cylinder):
    G = np.array([cylinder["radius"] * phi, 0.0]) + _from_centre(phi, cylinder["offset"])
    kinetic = contact_inertia(phi, mass=mass, **cylinder) * phi_dot**2 / 2
    return kinetic - _weight(mass, slope, gravity) @ G


def _velocity(phi, radius, offset):
    return np.array([radius, 0.0]) - offset * np.array([np.cos(phi), -np.sin(phi)])


def _centripetal(phi, phi_dot, offset):
    return -(phi_dot**2) * _from_centre(phi, offset)


def _from_centre(phi, offset):
    return np.array([-offset * np.sin(phi), -offset * np.cos(phi)])


def _weight(mass, slope, gravity):
    return mass * gravity * np.array([np.sin(slope), -np.cos(slope)])
