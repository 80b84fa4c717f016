"""A motion is kept by its start, and given again at other times.

fails: simulation_follows_the_equations
names: is a result kept between calls
"""

_right_simulate = simulate
_kept = {}


def simulate(t, theta, omega, *, masses, **known):
    key = (*theta, *omega, *masses, len(t))
    if key not in _kept:
        _kept[key] = _right_simulate(t, theta, omega, masses=masses, **known)
    return _kept[key]
