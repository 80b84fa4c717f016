"""The other definition: are b and c swapped?.

fails: discrepancy_with_the_velocity_in_F, discrepancy_with_the_velocity_relative_to_C
"""

def rate(definition, r_p, v_p, a_p, r_c, v_c, a_c, *, mass):
    _check(definition)
    term = {"a": 0 * r_p, "b": np.cross(v_p, mass * v_c), "c": np.cross(mass * a_c, r_p - r_c)}[definition]
    return np.cross(r_p - r_c, mass * a_p) + term


_right_discrepancy = discrepancy


def discrepancy(definition, *state, mass):
    _check(definition)
    return _right_discrepancy({"a": "a", "b": "c", "c": "b"}[definition], *state, mass=mass)
