"""The height of G above the ramp stands for its distance from C.

fails: contact_inertia_by_the_parallel_axis_theorem, naive_acceleration_is_the_moment_over_the_inertia, energy_of_G_and_of_turning
"""

_right = contact_inertia


def contact_inertia(phi, *, mass, radius, offset, inertia):
    return inertia + mass * (radius - offset * math.cos(phi)) ** 2
