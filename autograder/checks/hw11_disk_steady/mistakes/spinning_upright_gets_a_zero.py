"""Omega is 0 for an upright disk, even where it is not determined.

fails: rolling_precession_refuses_what_does_not_exist
names: does not raise ValueError for an upright disk on a point
"""


_precession = rolling_precession


def rolling_precession(lean, track_radius, **disk):
    return 0.0 if lean == 0.0 else _precession(lean, track_radius, **disk)
