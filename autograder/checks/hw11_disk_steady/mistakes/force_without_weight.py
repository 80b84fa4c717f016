"""The normal force lacks the weight.

fails: contact_force_moves_the_centre
"""


def contact_force(lean, precession, spin, *, mass, radius, gravity):
    return mass * radius * precession * spin, 0.0
