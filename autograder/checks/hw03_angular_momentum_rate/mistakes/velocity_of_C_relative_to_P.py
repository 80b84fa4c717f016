"""The velocity is v_{C/P}; it should be v_{P/C}.

fails: momentum_with_the_velocity_relative_to_C
"""

_right_momentum = angular_momentum


def angular_momentum(definition, r_p, v_p, r_c, v_c, *, mass):
    sign = -1 if definition == "c" else 1
    return sign * _right_momentum(definition, r_p, v_p, r_c, v_c, mass=mass)
