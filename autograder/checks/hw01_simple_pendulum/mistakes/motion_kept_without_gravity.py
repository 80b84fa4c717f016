"""A motion is kept by its times, start and length; another gravity gets the same motion.

fails: simulate_needs_no_dense_times
names: is a result kept between calls
"""

_right_simulate, _kept = simulate, {}


def simulate(t, theta0, omega0, *, length, gravity):
    key = (*t, theta0, omega0, length)
    if key not in _kept:
        _kept[key] = _right_simulate(t, theta0, omega0, length=length, gravity=gravity)
    return _kept[key].copy()
