"""The distance from C to G squared is r^2 + e^2, which holds only where O G is along the ramp.

fails: contact_inertia_by_the_parallel_axis_theorem, naive_acceleration_is_the_moment_over_the_inertia, energy_of_G_and_of_turning
"""


def contact_inertia(phi, *, mass, radius, offset, inertia):
    return inertia + mass * (radius**2 + offset**2)
