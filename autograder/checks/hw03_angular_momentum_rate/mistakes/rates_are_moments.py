"""The moment for the rate: in definition b, C moves while time goes on.

fails: rate_with_the_velocity_in_F, rate_with_the_velocity_relative_to_C, discrepancy_with_the_velocity_in_F, discrepancy_with_the_velocity_relative_to_C
also: the moment for the rate: the acceleration of C forgotten
"""

def discrepancy(definition, r_p, v_p, a_p, r_c, v_c, a_c, *, mass):
    _check(definition)
    return np.zeros(3)
