"""The spin is relative to the turning frame; the total spin is asked for.

fails: rolling_precession_balances_the_moments
"""


def rolling_precession(lean, track_radius, *, mass, radius, inertia, gravity):
    A, C = inertia
    c, s = math.cos(lean), math.sin(lean)
    resistance = c * (C * track_radius / radius + mass * radius * (track_radius - radius * s) + A * s)
    weight = mass * gravity * radius * s
    if resistance * weight < 0 or (resistance == 0.0 and weight == 0.0):
        raise ValueError("no steady rolling")
    return math.sqrt(weight / resistance)
