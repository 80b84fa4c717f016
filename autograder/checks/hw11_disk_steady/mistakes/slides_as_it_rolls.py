"""The spin is the spin of the rolling disk.

fails: sliding_spin_balances_the_moments
"""


def sliding_spin(lean, precession, **disk):
    return rolling_spin(lean, precession, **disk)
