"""A motion is kept by its start, masses and number of times, and given again at other times.

fails: simulation_follows_the_equations
names: but for other times; is something kept from one call to the next?
"""

_right_simulate = simulate
_kept = {}


def simulate(t, theta, omega, *, masses, **known):
    key = (*theta, *omega, *masses, len(t))
    if key not in _kept:
        _kept[key] = _right_simulate(t, theta, omega, masses=masses, **known)
    return _kept[key]
