"""Definition b has the velocity relative to C: this is definition c.

fails: momentum_with_the_velocity_in_F
also: has the term of definition c
"""


def angular_momentum(definition, r_p, v_p, r_c, v_c, *, mass):
    _check(definition)
    return np.cross(r_p - r_c, mass * (v_p if definition == "a" else v_p - v_c))
