"""The precession has C/2 where A belongs, as for a thin disk.

fails: rolling_precession_balances_the_moments
"""

_precession = rolling_precession


def rolling_precession(lean, track_radius, *, inertia, **disk):
    return _precession(lean, track_radius, inertia=(inertia[1] / 2, inertia[1]), **disk)
