"""The track of the rolling disk is a distance.

fails: rolling_track_has_the_contact_at_rest
suspect: the radius without its sign
"""

_track = rolling_track_radius


def rolling_track_radius(lean, precession, **disk):
    return abs(_track(lean, precession, **disk))
