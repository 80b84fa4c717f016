"""m a spin^2 for the mass times the centripetal acceleration.

fails: contact_force_moves_the_centre
"""


def contact_force(lean, precession, spin, *, mass, radius, gravity):
    return mass * radius * spin**2, mass * gravity
