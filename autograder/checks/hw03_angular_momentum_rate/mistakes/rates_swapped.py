"""The other definition: are b and c swapped?.

fails: rate_with_the_velocity_in_F, rate_with_the_velocity_relative_to_C
"""

_right_rate = rate


def rate(definition, *state, mass):
    _check(definition)
    return _right_rate({"a": "a", "b": "c", "c": "b"}[definition], *state, mass=mass)
