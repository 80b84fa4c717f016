"""The circle of G has the radius a spin / Omega, which straight rolling does not have.

fails: contact_force_of_straight_rolling
names: ZeroDivisionError for straight rolling, upright
"""


def contact_force(lean, precession, spin, *, mass, radius, gravity):
    circle = radius * spin / precession
    return mass * precession**2 * circle, mass * gravity
