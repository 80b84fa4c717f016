"""Without precession the whole force is left out; the weight remains.

fails: contact_force_of_straight_rolling
names: Nothing there goes round
also: The result of contact_force is zero
"""

_right = contact_force


def contact_force(lean, precession, spin, **disk):
    return _right(lean, precession, spin, **disk) if precession else (0.0, 0.0)
