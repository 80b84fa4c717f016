"""Omega has the sign of the lean; it should be positive or zero.

fails: rolling_precession_holds_on_tracks_of_any_sign, rolling_precession_is_zero_where_nothing_turns_it
"""

_precession = rolling_precession


def rolling_precession(lean, track_radius, **disk):
    return math.copysign(1.0, lean) * _precession(lean, track_radius, **disk)
