"""A motion is kept from an earlier call.

fails: with_gravity_it_swings_or_goes_round
"""

_right_simulate = simulate
_kept = {}


def simulate(t, state, *, length, **parameters):
    key = (*t, *state, length)
    if key not in _kept:
        _kept[key] = _right_simulate(t, state, length=length, **parameters)
    return _kept[key]
