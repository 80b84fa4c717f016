"""A gravity below 0.1 m/s^2 is treated as none.

fails: rolling_precession_is_zero_where_nothing_turns_it, common_precession_is_in_both_families
"""

_precession, _common = rolling_precession, common_precession


def rolling_precession(lean, track_radius, *, gravity, **disk):
    return _precession(lean, track_radius, gravity=gravity if gravity > 0.1 else 0.0, **disk)


def common_precession(lean, *, gravity, **disk):
    return _common(lean, gravity=gravity if gravity > 0.1 else 0.0, **disk)
