"""The angular momentum about a C at rest is zero; it should not be.

fails: momentum_with_the_velocity_in_F, momentum_with_the_velocity_relative_to_C
"""

_right_momentum = angular_momentum


def angular_momentum(definition, r_p, v_p, r_c, v_c, *, mass):
    right = _right_momentum(definition, r_p, v_p, r_c, v_c, mass=mass)
    return right if np.any(v_c) else np.zeros(3)
