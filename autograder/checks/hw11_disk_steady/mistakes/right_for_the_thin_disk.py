"""A and C belong to a thin uniform disk; use the given ones.

fails: rolling_precession_balances_the_moments
"""


def rolling_precession(lean, track_radius, *, mass, radius, inertia, gravity):
    resistance = 6 * track_radius - 5 * radius * math.sin(lean)
    if resistance == 0.0 or math.tan(lean) / resistance < 0.0 < gravity:
        raise ValueError("no steady rolling")
    return math.sqrt(max(4 * gravity * math.tan(lean) / resistance, 0.0))
