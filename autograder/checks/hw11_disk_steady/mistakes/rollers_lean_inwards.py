"""A disk whose lean and track radius have different signs is refused, a long roller too.

fails: rolling_precession_holds_on_tracks_of_any_sign
names: raised ValueError for a long roller whose contact lies beyond
"""

_right = rolling_precession


def rolling_precession(lean, track_radius, *, mass, radius, inertia, gravity):
    if lean * track_radius < 0.0 < gravity:
        raise ValueError("leans away")
    return _right(lean, track_radius, mass=mass, radius=radius, inertia=inertia, gravity=gravity)
