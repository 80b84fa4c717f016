"""The track radius R runs to G; it should run to the contact point.

fails: rolling_track_has_the_contact_at_rest, rolling_precession_balances_the_moments, sliding_track_is_around_the_resting_centre
"""


_precession, _track = rolling_precession, rolling_track_radius


def rolling_precession(lean, track_radius, **disk):
    return _precession(lean, track_radius + disk["radius"] * math.sin(lean), **disk)


def rolling_track_radius(lean, precession, **disk):
    return _track(lean, precession, **disk) - disk["radius"] * math.sin(lean)


def sliding_track_radius(lean, *, radius):
    return 0.0
