"""A motion is kept by its times, and given again for another pendulum.

fails: simulation_follows_the_equations
names: is a result kept between calls
"""

_right_simulate = simulate
_kept = {}


def simulate(t, theta, omega, **known):
    if tuple(t) not in _kept:
        _kept[tuple(t)] = _right_simulate(t, theta, omega, **known)
    return _kept[tuple(t)]
