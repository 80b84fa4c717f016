"""The spin is relative to the turning frame; the total spin is asked for.

fails: rolling_spin_balances_the_moments, rolling_track_has_the_contact_at_rest, sliding_spin_balances_the_moments
where: thin
"""


def rolling_spin(lean, precession, *, mass, radius, inertia, gravity):
    A, C = inertia
    excess = _spin_angular_momentum(lean, precession, mass, radius, inertia, gravity)
    return excess / (C + mass * radius**2) + precession * math.sin(lean)


def sliding_spin(lean, precession, *, mass, radius, inertia, gravity):
    A, C = inertia
    return _spin_angular_momentum(lean, precession, mass, radius, inertia, gravity) / C + precession * math.sin(lean)
