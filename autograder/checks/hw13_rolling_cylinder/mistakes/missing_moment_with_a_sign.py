"""phi_dot times its size for the square.

fails: missing_moment_makes_it_right
suspect: phi' times its size
"""


def missing_moment(phi, phi_dot, *, mass, radius, offset):
    return mass * radius * offset * math.sin(phi) * phi_dot * abs(phi_dot)
