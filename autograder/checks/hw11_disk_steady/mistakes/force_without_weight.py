"""The ground gives G its acceleration, and does not bear the weight.

fails: contact_force_moves_the_centre
suspect: no weight in the normal force
"""


def contact_force(lean, precession, spin, *, mass, radius, gravity):
    return mass * radius * precession * spin, 0.0
