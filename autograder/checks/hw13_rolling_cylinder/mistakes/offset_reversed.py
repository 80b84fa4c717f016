"""G away from the contact at phi = 0.

fails: acceleration_balances_momentum_about_G, contact_force_accelerates_G, simulate_rolls_and_rocks
suspect: other side of the centre
"""

_right = acceleration


def acceleration(phi, phi_dot, *, offset, **rest):
    return _right(phi, phi_dot, offset=-offset, **rest)
