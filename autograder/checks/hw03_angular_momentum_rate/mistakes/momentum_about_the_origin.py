"""The angular momentum is about O; it should be about C.

fails: momentum_with_the_velocity_in_F, momentum_with_the_velocity_relative_to_C
"""

def angular_momentum(definition, r_p, v_p, r_c, v_c, *, mass):
    _check(definition)
    return np.cross(r_p, mass * (v_p - v_c if definition == "c" else v_p))
