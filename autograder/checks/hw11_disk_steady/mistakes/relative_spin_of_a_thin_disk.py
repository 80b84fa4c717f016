"""The spin is relative to the turning frame, and A and C belong to a thin uniform disk.

fails: rolling_spin_balances_the_moments, rolling_track_has_the_contact_at_rest, sliding_spin_balances_the_moments
also: The spin is relative to the turning frame
"""


def _thin(mass, radius):
    return mass * radius**2 / 4, mass * radius**2 / 2


def rolling_spin(lean, precession, *, mass, radius, inertia, gravity):
    C = _thin(mass, radius)[1]
    excess = _spin_angular_momentum(lean, precession, mass, radius, _thin(mass, radius), gravity)
    return excess / (C + mass * radius**2) + precession * math.sin(lean)


def sliding_spin(lean, precession, *, mass, radius, inertia, gravity):
    excess = _spin_angular_momentum(lean, precession, mass, radius, _thin(mass, radius), gravity)
    return excess / _thin(mass, radius)[1] + precession * math.sin(lean)
