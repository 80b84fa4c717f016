"""A lean below 1e-4 is treated as none.

fails: rolling_precession_is_zero_where_nothing_turns_it, rolling_precession_refuses_what_does_not_exist
"""

_precession = rolling_precession


def rolling_precession(lean, track_radius, **disk):
    return _precession(lean if abs(lean) >= 1e-4 else 0.0, track_radius, **disk)
