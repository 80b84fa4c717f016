"""Definition a takes moments about the origin; it should be about C', which is fixed where C is now.

fails: momentum_with_the_velocity_in_F
"""

_right = angular_momentum


def angular_momentum(definition, r_p, v_p, r_c, v_c, *, mass):
    about = 0 * r_c if definition == "a" else r_c
    return _right(definition, r_p, v_p, about, v_c, mass=mass)
