"""Right for positive angles within half a turn.

fails: missing_moment_makes_it_right
suspect: the size of the sine
"""


def missing_moment(phi, phi_dot, *, mass, radius, offset):
    return mass * radius * offset * math.sqrt(1 - math.cos(phi) ** 2) * phi_dot**2
