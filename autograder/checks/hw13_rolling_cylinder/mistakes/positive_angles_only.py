"""The sine of phi has lost its sign: G may be on either side.

fails: missing_moment_makes_it_right
"""


def missing_moment(phi, phi_dot, *, mass, radius, offset):
    return mass * radius * offset * math.sqrt(1 - math.cos(phi) ** 2) * phi_dot**2
