"""G is put on the contact's circle of radius R; it has a circle of its own.

fails: contact_force_moves_the_centre
"""


def contact_force(lean, precession, spin, *, mass, radius, gravity):
    track = radius * (math.sin(lean) + spin / precession)
    return mass * precession**2 * track, mass * gravity
