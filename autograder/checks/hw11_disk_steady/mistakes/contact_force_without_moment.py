"""m a^2 is missing: the force that keeps G on its circle has a moment about G too.

fails: rolling_spin_balances_the_moments, rolling_track_has_the_contact_at_rest, rolling_precession_balances_the_moments
"""


def rolling_spin(lean, precession, *, mass, radius, inertia, gravity):
    return sliding_spin(lean, precession, mass=mass, radius=radius, inertia=inertia, gravity=gravity)


def rolling_precession(lean, track_radius, *, mass, radius, inertia, gravity):
    A, C = inertia
    resistance = math.cos(lean) * (C * (track_radius / radius - math.sin(lean)) + A * math.sin(lean))
    weight = mass * gravity * radius * math.sin(lean)
    if resistance * weight < 0 or (resistance == 0.0 and weight == 0.0):
        raise ValueError("no steady rolling")
    return math.sqrt(weight / resistance)
