"""Any other letter is treated as a; it should be refused.

fails: discrepancy_refuses_other_definitions
names: does not raise ValueError for the definition
"""

_right_discrepancy = discrepancy


def rate(definition, r_p, v_p, a_p, r_c, v_c, a_c, *, mass):
    surplus = _right_discrepancy(definition, r_p, v_p, a_p, r_c, v_c, a_c, mass=mass)
    return moment(r_p, a_p, r_c, mass=mass) + surplus


def discrepancy(definition, *state, mass):
    return _right_discrepancy(definition if definition in ("b", "c") else "a", *state, mass=mass)
