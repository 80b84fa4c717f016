"""G is put on the other side of the centre.

fails: acceleration_balances_momentum_about_G, contact_force_accelerates_G, simulate_rolls_and_rocks
"""

_right = acceleration


def acceleration(phi, phi_dot, *, offset, **rest):
    return _right(phi, phi_dot, offset=-offset, **rest)
