"""A motion is kept by body, omega and the number of times, and given again from another R and at other times.

fails: special_bodies_move_too
names: is a result kept between calls?
"""

_right_simulate = simulate
_kept = {}


def simulate(t, R, omega, *, inertia):
    key = (*omega, *inertia, len(t))
    if key not in _kept:
        _kept[key] = _right_simulate(t, R, omega, inertia=inertia)
    return _kept[key]
