"""R is a spin / Omega - a sin(lean).

fails: rolling_track_has_the_contact_at_rest
suspect: a sin(lean) taken off
"""

_track = rolling_track_radius


def rolling_track_radius(lean, precession, *, radius, **disk):
    return _track(lean, precession, radius=radius, **disk) - 2 * radius * math.sin(lean)
