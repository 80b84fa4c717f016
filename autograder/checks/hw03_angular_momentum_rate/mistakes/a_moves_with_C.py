"""Definition a has the rate of definition b: C' does not move.

fails: rate_about_a_fixed_point, no_discrepancy_about_a_fixed_point
"""

_right_discrepancy = discrepancy


def discrepancy(definition, *state, mass):
    return _right_discrepancy("b" if definition == "a" else definition, *state, mass=mass)
