"""The rate of definition c is only the moment: the acceleration of C is missing.

fails: rate_with_the_velocity_relative_to_C, discrepancy_with_the_velocity_relative_to_C
also: The rate of definition c is only the moment: the acceleration of C is missing
names: it vanishes
"""

def rate(definition, r_p, v_p, a_p, r_c, v_c, a_c, *, mass):
    _check(definition)
    of_b = np.cross(v_c, mass * v_p) if definition == "b" else 0
    return np.cross(r_p, mass * a_p) - np.cross(r_c, mass * a_p) - of_b


def discrepancy(definition, r_p, v_p, a_p, r_c, v_c, a_c, *, mass):
    return rate(definition, r_p, v_p, a_p, r_c, v_c, a_c, mass=mass) - moment(r_p, a_p, r_c, mass=mass)
