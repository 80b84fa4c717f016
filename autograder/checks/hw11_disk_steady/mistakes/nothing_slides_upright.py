"""An upright disk is refused a sliding spin, and its track has the radius of the disk; the track should be a point.

fails: sliding_spin_balances_the_moments, sliding_track_is_around_the_resting_centre
names: sliding_spin raised ValueError for an upright disk
"""

_spin, _track = sliding_spin, sliding_track_radius


def sliding_spin(lean, precession, **disk):
    if lean == 0:
        raise ValueError("upright")
    return _spin(lean, precession, **disk)


def sliding_track_radius(lean, *, radius):
    return _track(lean, radius=radius) if lean else radius
