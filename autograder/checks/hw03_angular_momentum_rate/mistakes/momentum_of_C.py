"""The momentum has the velocity of C; it should have the velocity of P.

fails: momentum_with_the_velocity_in_F, momentum_with_the_velocity_relative_to_C
"""


def angular_momentum(definition, r_p, v_p, r_c, v_c, *, mass):
    _check(definition)
    return np.cross(r_p - r_c, mass * v_c)
