"""The discrepancy is moment less rate; it should be rate less moment.

fails: discrepancy_with_the_velocity_in_F, discrepancy_with_the_velocity_relative_to_C
names: is it rate less moment
also: The discrepancy has the opposite sign
"""

_right_discrepancy = discrepancy


def rate(definition, r_p, v_p, a_p, r_c, v_c, a_c, *, mass):
    surplus = _right_discrepancy(definition, r_p, v_p, a_p, r_c, v_c, a_c, mass=mass)
    return moment(r_p, a_p, r_c, mass=mass) + surplus


def discrepancy(definition, r_p, v_p, a_p, r_c, v_c, a_c, *, mass):
    return moment(r_p, a_p, r_c, mass=mass) - rate(definition, r_p, v_p, a_p, r_c, v_c, a_c, mass=mass)
