"""Definition c has the term of definition b, too.

fails: rate_with_the_velocity_relative_to_C, discrepancy_with_the_velocity_relative_to_C
"""

_right_discrepancy = discrepancy


def discrepancy(definition, r_p, v_p, a_p, r_c, v_c, a_c, *, mass):
    state = r_p, v_p, a_p, r_c, v_c, a_c
    if definition != "c":
        return _right_discrepancy(definition, *state, mass=mass)
    return _right_discrepancy("b", *state, mass=mass) + _right_discrepancy("c", *state, mass=mass)
