"""Omega^2 has lost its sign, and an upright spinning disk gets 0.

fails: rolling_precession_refuses_what_does_not_exist
names: does not raise ValueError for a disk that leans away from the centre
"""


def rolling_precession(lean, track_radius, *, mass, radius, inertia, gravity):
    A, C = inertia
    rolling = C + mass * radius**2
    resistance = math.cos(lean) * (rolling * (track_radius / radius - math.sin(lean)) + A * math.sin(lean))
    weight = mass * gravity * radius * math.sin(lean)
    return math.sqrt(abs(weight / resistance)) if weight else 0.0
