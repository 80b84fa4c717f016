"""The inward force has the cosine of the lean, as if G's acceleration were along the axle.

fails: contact_force_moves_the_centre
suspect: the cosine of the lean in the inward force
"""


def contact_force(lean, precession, spin, *, mass, radius, gravity):
    return mass * radius * precession * spin * math.cos(lean), mass * gravity
