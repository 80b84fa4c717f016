"""The whole rate of I^C times phi_dot.

fails: missing_moment_makes_it_right
suspect: twice the term
"""


def missing_moment(phi, phi_dot, *, mass, radius, offset):
    return 2 * mass * radius * offset * math.sin(phi) * phi_dot**2
