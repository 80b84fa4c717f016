"""I^C has its value at phi = 0 everywhere, but only there the distance from C to G is r - e.

fails: contact_inertia_by_the_parallel_axis_theorem, naive_acceleration_is_the_moment_over_the_inertia, energy_of_G_and_of_turning
"""


def contact_inertia(phi, *, mass, radius, offset, inertia):
    return inertia + mass * (radius - offset) ** 2
