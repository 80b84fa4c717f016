"""The distance from C to the centre stands where the distance from C to G belongs.

fails: contact_inertia_by_the_parallel_axis_theorem
"""

_right, _energy, _naive = contact_inertia, energy, naive_contact_acceleration


def contact_inertia(phi, *, mass, radius, offset, inertia):
    return inertia + mass * radius**2


def energy(phi, phi_dot, **c):
    body = {name: c[name] for name in ("mass", "radius", "offset", "inertia")}
    return _energy(phi, 0.0, **c) + _right(phi, **body) * phi_dot**2 / 2


def naive_contact_acceleration(phi, **c):
    body = {name: c[name] for name in ("mass", "radius", "offset", "inertia")}
    return _naive(phi, **c) * contact_inertia(phi, **body) / _right(phi, **body)
