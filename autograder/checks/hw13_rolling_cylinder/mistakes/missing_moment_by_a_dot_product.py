"""It is a dot product of r_{G/C} and m a_C; the moment is their cross product.

fails: missing_moment_makes_it_right
"""


def missing_moment(phi, phi_dot, *, mass, radius, offset):
    return mass * (radius - offset * math.cos(phi)) * radius * phi_dot**2
