"""The circle of G has a radius of its own, not R of the contact's track.

fails: contact_force_moves_the_centre
"""


def contact_force(lean, precession, spin, *, mass, radius, gravity):
    track = radius * (math.sin(lean) + spin / precession)
    return mass * precession**2 * track, mass * gravity
