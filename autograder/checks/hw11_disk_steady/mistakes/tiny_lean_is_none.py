"""A lean below 1e-6 is treated as none.

fails: rolling_precession_refuses_what_does_not_exist
names: ValueError for a roller that turns on a point, its lean tiny but not zero
"""

_precession = rolling_precession


def rolling_precession(lean, track_radius, **disk):
    if abs(lean) < 1e-6 and disk["gravity"]:
        return 0.0 if track_radius else _zero_on_a_point(lean, track_radius, **disk)
    return _precession(lean, track_radius, **disk)


def _zero_on_a_point(lean, track_radius, **disk):
    if lean == 0.0:
        raise ValueError
    return 0.0
