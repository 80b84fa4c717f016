"""The inward force is m a spin^2; it should be the mass times the centripetal acceleration of G.

fails: contact_force_moves_the_centre
"""


def contact_force(lean, precession, spin, *, mass, radius, gravity):
    return mass * radius * spin**2, mass * gravity
