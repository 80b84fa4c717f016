"""R, of the contact's track, for the radius of the circle of G.

fails: contact_force_moves_the_centre
"""


def contact_force(lean, precession, spin, *, mass, radius, gravity):
    track = radius * (math.sin(lean) + spin / precession)
    return mass * precession**2 * track, mass * gravity
