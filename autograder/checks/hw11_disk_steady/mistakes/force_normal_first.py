"""The normal force first; the inward force is asked first.

fails: contact_force_moves_the_centre
"""


def contact_force(lean, precession, spin, *, mass, radius, gravity):
    return mass * gravity, mass * radius * precession * spin
