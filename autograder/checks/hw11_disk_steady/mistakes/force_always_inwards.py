"""The inward force is never negative.

fails: contact_force_moves_the_centre
suspect: the inward force taken without its sign
"""


def contact_force(lean, precession, spin, *, mass, radius, gravity):
    return mass * radius * abs(precession * spin), mass * gravity
