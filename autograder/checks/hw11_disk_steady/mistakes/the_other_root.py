"""The negative root of Omega^2.

fails: rolling_precession_balances_the_moments
suspect: the sign turned round
"""


_precession = rolling_precession


def rolling_precession(lean, track_radius, **disk):
    return -_precession(lean, track_radius, **disk)
