"""The velocity is relative to C in every definition; it should be so only in c.

fails: momentum_with_the_velocity_in_F
also: Definition b has the term of definition c
"""

def angular_momentum(definition, r_p, v_p, r_c, v_c, *, mass):
    _check(definition)
    return np.cross(r_p - r_c, mass * (v_p - v_c))
