"""Omega is negative; Omega >= 0 is asked for.

fails: rolling_precession_balances_the_moments
"""


_precession = rolling_precession


def rolling_precession(lean, track_radius, **disk):
    return -_precession(lean, track_radius, **disk)
