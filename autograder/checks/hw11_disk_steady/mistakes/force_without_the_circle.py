"""The inward force is m a spin^2.

fails: contact_force_moves_the_centre
suspect: m a spin^2
"""


def contact_force(lean, precession, spin, *, mass, radius, gravity):
    return mass * radius * spin**2, mass * gravity
