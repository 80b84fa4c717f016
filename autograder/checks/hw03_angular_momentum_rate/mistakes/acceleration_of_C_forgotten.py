"""The rate of definition c is only the moment: the acceleration of C is missing.

fails: rate_with_the_velocity_relative_to_C, discrepancy_with_the_velocity_relative_to_C
"""

_right_discrepancy = discrepancy


def discrepancy(definition, *state, mass):
    return _right_discrepancy(definition, *state, mass=mass) if definition != "c" else np.zeros(3)
