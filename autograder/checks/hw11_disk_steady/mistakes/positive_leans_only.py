"""A lean that is not positive is refused, though the track may be negative too.

fails: rolling_precession_holds_on_tracks_of_any_sign, rolling_precession_is_zero_where_nothing_turns_it
names: raised ValueError for an upright disk and a positive track radius
"""


_precession = rolling_precession


def rolling_precession(lean, track_radius, **disk):
    if lean <= 0.0:
        raise ValueError("it does not lean inwards")
    return _precession(lean, track_radius, **disk)
