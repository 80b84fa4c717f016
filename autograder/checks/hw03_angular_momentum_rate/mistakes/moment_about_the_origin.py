"""The moment is about O; it should be about C.

fails: moment_is_about_C, rate_about_a_fixed_point, rate_with_the_velocity_in_F, rate_with_the_velocity_relative_to_C
"""

def moment(r_p, a_p, r_c, *, mass):
    return np.cross(r_p, mass * a_p)
