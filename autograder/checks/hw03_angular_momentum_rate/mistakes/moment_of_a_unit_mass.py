"""The moment lacks the mass.

fails: moment_is_about_C
"""

_right_moment = moment


def rate(definition, r_p, v_p, a_p, r_c, v_c, a_c, *, mass):
    surplus = discrepancy(definition, r_p, v_p, a_p, r_c, v_c, a_c, mass=mass)
    return _right_moment(r_p, a_p, r_c, mass=mass) + surplus


def moment(r_p, a_p, r_c, *, mass):
    return np.cross(r_p - r_c, a_p)
