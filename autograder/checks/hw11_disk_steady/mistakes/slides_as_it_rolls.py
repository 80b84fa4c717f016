"""The sliding disk gets the spin of the rolling one.

fails: sliding_spin_balances_the_moments
suspect: the spin of the rolling disk
"""


def sliding_spin(lean, precession, **disk):
    return rolling_spin(lean, precession, **disk)
