"""a sin(lean) is subtracted from the track radius; it should be added.

fails: rolling_track_has_the_contact_at_rest
"""

_track = rolling_track_radius


def rolling_track_radius(lean, precession, *, radius, **disk):
    return _track(lean, precession, radius=radius, **disk) - 2 * radius * math.sin(lean)
