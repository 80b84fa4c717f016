"""A track radius that is not positive is refused.

fails: rolling_precession_holds_on_tracks_of_any_sign, rolling_precession_is_zero_where_nothing_turns_it
names: raised ValueError for an upright disk and a negative track radius
"""


_precession = rolling_precession


def rolling_precession(lean, track_radius, **disk):
    if track_radius <= 0.0:
        raise ValueError("no such circle")
    return _precession(lean, track_radius, **disk)
