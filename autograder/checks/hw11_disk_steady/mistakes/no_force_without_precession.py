"""Where nothing goes round there is no force at all.

fails: contact_force_of_straight_rolling
names: Nothing there goes round
"""

_right = contact_force


def contact_force(lean, precession, spin, **disk):
    return _right(lean, precession, spin, **disk) if precession else (0.0, 0.0)
