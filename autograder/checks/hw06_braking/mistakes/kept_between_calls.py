"""A motion is kept by axle and start, and given again at other times and for other cars.

fails: simulate_needs_no_dense_times
"""

_right_simulate = simulate
_kept = {}


def simulate(t, state, locked, **car):
    key = (locked, *state, len(t))
    if key not in _kept:
        _kept[key] = _right_simulate(t, state, locked, **car)
    return _kept[key]
