"""Without gravity you raise ValueError for some leans; a disk at rest, Omega = 0, is a solution for every lean.

fails: rolling_precession_is_zero_where_nothing_turns_it
names: raised ValueError for no gravity, and a lean away from the centre
"""


def rolling_precession(lean, track_radius, *, mass, radius, inertia, gravity):
    A, C = inertia
    if lean == 0.0 != track_radius:
        return 0.0
    resistance = A * math.sin(lean) + (C + mass * radius**2) * (track_radius / radius - math.sin(lean))
    if resistance * lean <= 0.0:
        raise ValueError("no Omega")
    return math.sqrt(mass * gravity * radius * math.tan(lean) / resistance)
