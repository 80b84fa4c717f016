"""Omega is negative; it should be positive or zero.

fails: rolling_precession_balances_the_moments
"""


_precession = rolling_precession


def rolling_precession(lean, track_radius, **disk):
    return -_precession(lean, track_radius, **disk)
