"""The moment is divided by the offset, which is zero for a centred cylinder.

fails: centred_cylinder_rolls_by_both_methods, naive_acceleration_is_the_moment_over_the_inertia
names: ZeroDivisionError for G at the centre
"""

_right = naive_contact_acceleration


def naive_contact_acceleration(phi, *, offset, **rest):
    return offset * (_right(phi, offset=offset, **rest) / offset)
