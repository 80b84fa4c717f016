"""The rate is the moment by every definition.

fails: rate_with_the_velocity_in_F, rate_with_the_velocity_relative_to_C, discrepancy_with_the_velocity_in_F, discrepancy_with_the_velocity_relative_to_C
suspect: the moment for the rate
"""

def discrepancy(definition, r_p, v_p, a_p, r_c, v_c, a_c, *, mass):
    _check(definition)
    return np.zeros(3)
