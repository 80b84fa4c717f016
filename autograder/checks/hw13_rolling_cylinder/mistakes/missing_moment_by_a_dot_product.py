"""The term is a dot product of r_{G/C} and m a_C; it should be their cross product.

fails: missing_moment_makes_it_right
"""


def missing_moment(phi, phi_dot, *, mass, radius, offset):
    return mass * (radius - offset * math.cos(phi)) * radius * phi_dot**2
