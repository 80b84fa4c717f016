"""This is the inertia about the centre; it should be about C.

fails: centred_cylinder_rolls_by_both_methods, contact_inertia_by_the_parallel_axis_theorem, naive_acceleration_is_the_moment_over_the_inertia, energy_of_G_and_of_turning
"""


def contact_inertia(phi, *, mass, radius, offset, inertia):
    return inertia + mass * offset**2
