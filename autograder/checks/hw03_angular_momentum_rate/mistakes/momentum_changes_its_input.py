"""The lever arm replaces r_P in the given array; work on a copy.

fails: momentum_with_the_velocity_in_F, momentum_with_the_velocity_relative_to_C
names: angular_momentum changes the arrays
"""

def angular_momentum(definition, r_p, v_p, r_c, v_c, *, mass):
    _check(definition)
    r_p -= r_c
    return np.cross(r_p, mass * (v_p - v_c if definition == "c" else v_p))
