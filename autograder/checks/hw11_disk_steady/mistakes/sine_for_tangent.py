"""The moment of the weight has sin(lean) where tan(lean) belongs; the cosine divides that term, too.

fails: rolling_spin_balances_the_moments, rolling_track_has_the_contact_at_rest
"""


def rolling_spin(lean, precession, *, mass, radius, inertia, gravity):
    A, C = inertia
    moment = mass * gravity * radius * math.sin(lean) - A * precession**2 * math.sin(lean)
    return moment / (precession * (C + mass * radius**2))
