"""Without gravity Omega is 0, even upright on a point, where it is not determined.

fails: rolling_precession_refuses_what_does_not_exist
names: does not raise ValueError for an upright disk on a point without gravity
"""

_precession = rolling_precession


def rolling_precession(lean, track_radius, **disk):
    return _precession(lean, track_radius, **disk) if disk["gravity"] else 0.0
