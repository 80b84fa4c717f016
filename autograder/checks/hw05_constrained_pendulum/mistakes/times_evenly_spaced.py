"""The times are treated as evenly spaced.

fails: without_gravity_it_goes_round_uniformly, with_gravity_it_swings_or_goes_round
also: the times are treated as evenly spaced, with the first step for all
"""

_right_simulate = simulate


def simulate(t, state, **parameters):
    return _right_simulate(np.linspace(t[0], t[-1], len(t)), state, **parameters)
