"""An upright disk on a track of less than a fifth of its radius is treated as spinning on a point.

fails: rolling_precession_is_zero_where_nothing_turns_it
names: ValueError for an upright disk and a positive track radius, far below the radius of the disk
"""

_precession = rolling_precession


def rolling_precession(lean, track_radius, *, radius, **disk):
    if lean == 0.0 and abs(track_radius) < radius / 5:
        raise ValueError("every Omega will do")
    return _precession(lean, track_radius, radius=radius, **disk)
