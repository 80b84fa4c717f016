"""You take the factor of Omega^2 for zero below 1e-6 kg m^2; for a coin it is that small.

fails: rolling_precession_holds_on_tracks_of_any_sign
names: rolling_precession raised ValueError for a thin disk as small as a coin
"""

_precession = rolling_precession


def rolling_precession(lean, track_radius, *, mass, radius, inertia, gravity):
    A, C = inertia
    resistance = A * math.sin(lean) + (C + mass * radius**2) * (track_radius / radius - math.sin(lean))
    if lean and gravity and abs(resistance) < 1e-6:
        raise ValueError("no Omega")
    return _precession(lean, track_radius, mass=mass, radius=radius, inertia=inertia, gravity=gravity)
