"""A motion is kept from an earlier call, whatever the times between the ends.

fails: with_gravity_it_swings_or_goes_round
"""

_right_simulate = simulate
_kept = {}


def simulate(t, state, **parameters):
    key = (*state, *parameters.values(), len(t), t[0], t[-1])
    if key not in _kept:
        _kept[key] = _right_simulate(t, state, **parameters)
    return _kept[key]
