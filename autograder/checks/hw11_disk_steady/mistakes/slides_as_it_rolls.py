"""The sliding disk is given the spin of the rolling one.

fails: sliding_spin_balances_the_moments
"""


def sliding_spin(lean, precession, **disk):
    return rolling_spin(lean, precession, **disk)
