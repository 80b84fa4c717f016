"""The weight acts at the centre; it should act at G.

fails: naive_acceleration_is_the_moment_over_the_inertia
"""


def naive_contact_acceleration(phi, *, mass, radius, offset, inertia, slope, gravity):
    body = {"mass": mass, "radius": radius, "offset": offset, "inertia": inertia}
    return mass * gravity * radius * math.sin(slope) / contact_inertia(phi, **body)
