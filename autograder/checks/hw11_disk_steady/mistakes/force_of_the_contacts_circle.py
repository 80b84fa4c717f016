"""The inward force is m Omega^2 R, with the radius of the contact's track; G goes round on another circle.

fails: contact_force_moves_the_centre
suspect: R, of the contact's track, for the radius of the circle of G
"""


def contact_force(lean, precession, spin, *, mass, radius, gravity):
    track = radius * (math.sin(lean) + spin / precession)
    return mass * precession**2 * track, mass * gravity
