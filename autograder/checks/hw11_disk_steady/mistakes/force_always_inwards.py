"""The inward force has lost its sign.

fails: contact_force_moves_the_centre
"""


def contact_force(lean, precession, spin, *, mass, radius, gravity):
    return mass * radius * abs(precession * spin), mass * gravity
