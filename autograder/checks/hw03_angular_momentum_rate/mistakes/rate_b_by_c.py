"""Definition b has the term of definition c: -r_{P/C} x m a_C.

fails: rate_with_the_velocity_in_F, discrepancy_with_the_velocity_in_F
"""

_right_discrepancy = discrepancy


def discrepancy(definition, r_p, v_p, a_p, r_c, v_c, a_c, *, mass):
    state = r_p, v_p, a_p, r_c, v_c, a_c
    if definition != "b":
        return _right_discrepancy(definition, *state, mass=mass)
    return _right_discrepancy("c", *state, mass=mass)
