"""The track radius has lost its sign.

fails: rolling_track_has_the_contact_at_rest
"""

_track = rolling_track_radius


def rolling_track_radius(lean, precession, **disk):
    return abs(_track(lean, precession, **disk))
