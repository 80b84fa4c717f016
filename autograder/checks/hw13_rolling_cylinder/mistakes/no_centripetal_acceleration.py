"""The terms in phi_dot squared are missing in the acceleration of G.

fails: contact_force_accelerates_G
"""


def contact_force(phi, phi_dot, *, mass, radius, offset, slope, gravity, **rest):
    a = acceleration(phi, phi_dot, mass=mass, radius=radius, offset=offset, slope=slope, gravity=gravity, **rest)
    along = mass * (radius - offset * math.cos(phi)) * a - mass * gravity * math.sin(slope)
    return along, mass * offset * math.sin(phi) * a + mass * gravity * math.cos(slope)
