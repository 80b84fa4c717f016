"""The rate of definition b: a point C' that moves.

fails: rate_about_a_fixed_point, no_discrepancy_about_a_fixed_point
"""

_right_discrepancy = discrepancy


def discrepancy(definition, *state, mass):
    return _right_discrepancy("b" if definition == "a" else definition, *state, mass=mass)
