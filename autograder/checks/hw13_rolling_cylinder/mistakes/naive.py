"""M_C = I^C phi'' throughout.

fails: acceleration_balances_momentum_about_G, contact_force_accelerates_G, simulate_rolls_and_rocks
suspect: M_C = I^C phi''
"""


def acceleration(phi, phi_dot, **cylinder):
    return naive_contact_acceleration(phi, **cylinder)
