"""I^G stands where I^C belongs.

fails: centred_cylinder_rolls_by_both_methods, naive_acceleration_is_the_moment_over_the_inertia
also: This is the inertia about the centre; it should be about C
"""

_right = naive_contact_acceleration


def naive_contact_acceleration(phi, *, mass, radius, offset, inertia, **ramp):
    body = {"mass": mass, "radius": radius, "offset": offset, "inertia": inertia}
    return _right(phi, **body, **ramp) * contact_inertia(phi, **body) / inertia
