"""Without gravity the spin is given as 0; a disk that precesses still spins.

fails: rolling_spin_holds_upright_and_without_gravity, rolling_track_has_the_contact_at_rest
"""


_spin = rolling_spin


def rolling_spin(lean, precession, **disk):
    return _spin(lean, precession, **disk) if disk["gravity"] else 0.0
