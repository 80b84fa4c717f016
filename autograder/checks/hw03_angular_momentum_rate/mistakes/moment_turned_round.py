"""The lever arm runs from P to C; it should run from C to P.

fails: moment_is_about_C, rate_about_a_fixed_point, rate_with_the_velocity_in_F, rate_with_the_velocity_relative_to_C
"""

def moment(r_p, a_p, r_c, *, mass):
    return np.cross(mass * a_p, r_p - r_c)
