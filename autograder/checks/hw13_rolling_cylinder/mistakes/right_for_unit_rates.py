"""phi' stands where its square belongs.

fails: missing_moment_makes_it_right
"""


def missing_moment(phi, phi_dot, *, mass, radius, offset):
    return mass * radius * offset * math.sin(phi) * phi_dot
