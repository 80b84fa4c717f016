"""Any other letter is treated as a by rate; it should be refused. The discrepancy is right.

fails: rate_refuses_other_definitions
names: does not raise ValueError for the definition
"""

_right_rate = rate


def rate(definition, *state, mass):
    return _right_rate(definition if definition in ("b", "c") else "a", *state, mass=mass)
