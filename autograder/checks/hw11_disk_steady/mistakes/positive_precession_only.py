"""The precession has lost its sign.

fails: rolling_spin_balances_the_moments, rolling_track_has_the_contact_at_rest
"""


_spin = rolling_spin


def rolling_spin(lean, precession, **disk):
    return _spin(lean, abs(precession), **disk)
