"""The rate of definition b is only the moment; C moves while time goes on.

fails: rate_with_the_velocity_in_F, rate_with_the_velocity_relative_to_C, discrepancy_with_the_velocity_in_F, discrepancy_with_the_velocity_relative_to_C
also: The rate of definition c is only the moment: the acceleration of C is missing
"""

def discrepancy(definition, r_p, v_p, a_p, r_c, v_c, a_c, *, mass):
    _check(definition)
    return np.zeros(3)
