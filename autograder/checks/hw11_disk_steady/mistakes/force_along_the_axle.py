"""The inward force has the cosine of the lean; it should not, as it is horizontal.

fails: contact_force_moves_the_centre
"""


def contact_force(lean, precession, spin, *, mass, radius, gravity):
    return mass * radius * precession * spin * math.cos(lean), mass * gravity
