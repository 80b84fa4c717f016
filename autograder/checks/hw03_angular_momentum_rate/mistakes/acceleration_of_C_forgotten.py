"""In c, the relative velocity differentiated as if C moved uniformly.

fails: rate_with_the_velocity_relative_to_C, discrepancy_with_the_velocity_relative_to_C
suspect: acceleration of C forgotten
"""

_right_discrepancy = discrepancy


def discrepancy(definition, *state, mass):
    return _right_discrepancy(definition, *state, mass=mass) if definition != "c" else np.zeros(3)
