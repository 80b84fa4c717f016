"""A disk that leans by more than 1.4 rad is treated as fallen.

fails: rolling_spin_holds_upright_and_without_gravity, rolling_track_has_the_contact_at_rest, rolling_precession_holds_on_tracks_of_any_sign, common_precession_has_a_limit_upright, settling_energy_adds_up
"""

_spin, _precession, _common, _energy = rolling_spin, rolling_precession, common_precession, settling_energy


def rolling_spin(lean, precession, **disk):
    return _spin(lean, precession, **disk) if abs(lean) < 1.4 else 0.0


def rolling_precession(lean, track_radius, **disk):
    if abs(lean) > 1.4:
        raise ValueError("it has fallen")
    return _precession(lean, track_radius, **disk)


def common_precession(lean, **disk):
    return _common(lean, **disk) if abs(lean) < 1.4 else 0.0


def settling_energy(lean, **disk):
    return _energy(lean, **disk) if abs(lean) < 1.4 else 0.0
