"""The equation is divided by the factor of Omega^2, which may be zero.

fails: rolling_precession_refuses_what_does_not_exist
names: ValueError for a roller that turns on a point
"""


def rolling_precession(lean, track_radius, *, mass, radius, inertia, gravity):
    A, C = inertia
    if lean == 0.0 and track_radius == 0.0:
        raise ValueError("any Omega")
    weight = mass * gravity * radius * math.tan(lean)
    if weight == 0.0:
        return 0.0
    square = weight / (A * math.sin(lean) + (C + mass * radius**2) * (track_radius / radius - math.sin(lean)))
    if square < 0.0:
        raise ValueError("no Omega")
    return math.sqrt(square)
