"""The normal force has the cosine of a lean that is negative.

fails: contact_force_moves_the_centre
names: Only the normal force is
"""


def contact_force(lean, precession, spin, *, mass, radius, gravity):
    return mass * radius * precession * spin, mass * gravity * math.cos(min(lean, 0.0))
