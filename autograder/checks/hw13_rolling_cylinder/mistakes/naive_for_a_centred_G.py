"""The naive equation with I^G + m r^2, which is I^C for a G at the centre alone.

fails: naive_acceleration_is_the_moment_over_the_inertia
suspect: I^G + m r^2 for I^C
"""

_right = naive_contact_acceleration


def naive_contact_acceleration(phi, *, mass, radius, offset, inertia, **ramp):
    body = {"mass": mass, "radius": radius, "offset": offset, "inertia": inertia}
    return _right(phi, **body, **ramp) * contact_inertia(phi, **body) / (inertia + mass * radius**2)
