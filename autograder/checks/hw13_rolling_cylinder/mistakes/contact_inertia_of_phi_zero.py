"""I^C is that of phi = 0 at every phi: only there is G as far from C as r - e.

fails: contact_inertia_by_the_parallel_axis_theorem, naive_acceleration_is_the_moment_over_the_inertia, energy_of_G_and_of_turning
"""


def contact_inertia(phi, *, mass, radius, offset, inertia):
    return inertia + mass * (radius - offset) ** 2
