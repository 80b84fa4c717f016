"""The mass and the radius are 1, not the given ones.

fails: rolling_spin_balances_the_moments, rolling_track_has_the_contact_at_rest
"""


def rolling_spin(lean, precession, *, mass, radius, inertia, gravity):
    A, C = inertia
    return math.sin(lean) * (gravity / (precession * math.cos(lean)) - A * precession) / (C + 1.0)
