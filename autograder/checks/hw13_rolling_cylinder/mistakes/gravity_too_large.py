"""The gravity is not the given one.

fails: centred_cylinder_rolls_by_both_methods, acceleration_balances_momentum_about_G, contact_force_accelerates_G, simulate_rolls_and_rocks
names: at rest it is wrong, too
"""

_right = acceleration


def acceleration(phi, phi_dot, *, gravity, **cylinder):
    return _right(phi, phi_dot, gravity=1.3 * gravity, **cylinder)
