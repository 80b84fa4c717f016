"""I^G + m r^2 stands where I^C belongs, which is right only with G at the centre.

fails: naive_acceleration_is_the_moment_over_the_inertia
"""

_right = naive_contact_acceleration


def naive_contact_acceleration(phi, *, mass, radius, offset, inertia, **ramp):
    body = {"mass": mass, "radius": radius, "offset": offset, "inertia": inertia}
    return _right(phi, **body, **ramp) * contact_inertia(phi, **body) / (inertia + mass * radius**2)
