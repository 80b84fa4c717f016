"""Definition a has the rate of definition c: its velocities are not relative to C.

fails: rate_about_a_fixed_point, no_discrepancy_about_a_fixed_point
"""

_right_discrepancy = discrepancy


def discrepancy(definition, r_p, v_p, a_p, r_c, v_c, a_c, *, mass):
    state = r_p, v_p, a_p, r_c, v_c, a_c
    if definition != "a":
        return _right_discrepancy(definition, *state, mass=mass)
    return _right_discrepancy("c", *state, mass=mass)
