"""The normal force comes first; the result is (inward, normal).

fails: contact_force_moves_the_centre
"""


def contact_force(lean, precession, spin, *, mass, radius, gravity):
    return mass * gravity, mass * radius * precession * spin
