"""M_C = I^C phi'', which leaves out that G is not above C.

fails: acceleration_balances_momentum_about_G, contact_force_accelerates_G, simulate_rolls_and_rocks
also: half the term that M_C = I^C phi'' lacks | twice the term that M_C = I^C phi'' lacks | the term that M_C = I^C phi'' lacks, its sign reversed | M_C = I^C phi'', which leaves out that G is not above C, for the acceleration | half the term that M_C = I^C phi'' lacks, for the acceleration | twice the term that M_C = I^C phi'' lacks, for the acceleration | the term that M_C = I^C phi'' lacks, its sign reversed, for the acceleration
"""


def acceleration(phi, phi_dot, **cylinder):
    return naive_contact_acceleration(phi, **cylinder)
