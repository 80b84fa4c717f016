"""The terms in phi_dot squared have a wrong factor.

fails: acceleration_balances_momentum_about_G, contact_force_accelerates_G, simulate_rolls_and_rocks
names: at rest it is right
"""

_right = acceleration


def acceleration(phi, phi_dot, **cylinder):
    return _right(phi, phi_dot / 1.2, **cylinder)
