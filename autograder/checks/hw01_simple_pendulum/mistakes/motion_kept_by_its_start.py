"""A motion is kept by its start and the number of its times; other times get the same motion.

fails: simulate_needs_no_dense_times
names: is a result kept between calls
"""

_right_simulate, _kept = simulate, {}


def simulate(t, theta0, omega0, **rod):
    key = (len(t), theta0, omega0)
    if key not in _kept:
        _kept[key] = _right_simulate(t, theta0, omega0, **rod)
    return _kept[key].copy()
