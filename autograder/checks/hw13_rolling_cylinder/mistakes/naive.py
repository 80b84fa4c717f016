"""You used M_C = I^C phi''; it leaves out the acceleration of the cylinder's point at C.

fails: acceleration_balances_momentum_about_G, contact_force_accelerates_G, simulate_rolls_and_rocks
"""


def acceleration(phi, phi_dot, **cylinder):
    return naive_contact_acceleration(phi, **cylinder)
