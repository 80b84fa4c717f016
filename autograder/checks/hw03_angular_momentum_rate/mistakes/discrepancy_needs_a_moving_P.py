"""Definition c is given no discrepancy while P is at rest.

fails: discrepancy_with_the_velocity_relative_to_C, rate_with_the_velocity_relative_to_C
"""

_right_discrepancy = discrepancy


def discrepancy(definition, r_p, v_p, a_p, r_c, v_c, a_c, *, mass):
    right = _right_discrepancy(definition, r_p, v_p, a_p, r_c, v_c, a_c, mass=mass)
    return right if definition != "c" or np.any(v_p) else np.zeros(3)
