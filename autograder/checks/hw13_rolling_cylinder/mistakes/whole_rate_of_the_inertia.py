"""This is twice the term: the whole rate of I^C times phi'.

fails: missing_moment_makes_it_right
"""


def missing_moment(phi, phi_dot, *, mass, radius, offset):
    return 2 * mass * radius * offset * math.sin(phi) * phi_dot**2
