"""cos(phi) stands where sin(phi) belongs.

fails: missing_moment_makes_it_right
"""


def missing_moment(phi, phi_dot, *, mass, radius, offset):
    return mass * radius * offset * math.cos(phi) * phi_dot**2
