"""At phi = 0 I^C belongs to a centred cylinder, and at rest the contact force is zero.

fails: contact_inertia_by_the_parallel_axis_theorem, naive_acceleration_is_the_moment_over_the_inertia, contact_force_accelerates_G, energy_of_G_and_of_turning
"""

_inertia, _force = contact_inertia, contact_force


def contact_inertia(phi, *, mass, radius, offset, inertia):
    return _inertia(phi, mass=mass, radius=radius, offset=offset if phi else 0.0, inertia=inertia)


def contact_force(phi, phi_dot, **cylinder):
    return _force(phi, phi_dot, **cylinder) if phi_dot else (0.0, 0.0)
