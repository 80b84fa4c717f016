"""A motion is kept by start, parameters and the number of times, and given again at other times.

fails: with_gravity_it_swings_or_goes_round
names: is something kept from one call to the next?
"""

_right_simulate = simulate
_kept = {}


def simulate(t, state, **parameters):
    key = (*state, *parameters.values(), len(t), t[0], t[-1])
    if key not in _kept:
        _kept[key] = _right_simulate(t, state, **parameters)
    return _kept[key]
