"""The pair comes the other way round.

fails: contact_force_moves_the_centre
suspect: the normal force first
"""


def contact_force(lean, precession, spin, *, mass, radius, gravity):
    return mass * gravity, mass * radius * precession * spin
