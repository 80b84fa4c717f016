"""The times are treated as evenly spaced, with the first step for all.

fails: without_gravity_it_goes_round_uniformly, with_gravity_it_swings_or_goes_round
"""

_right_simulate = simulate


def simulate(t, state, **parameters):
    return _right_simulate(t[0] + (t[1] - t[0]) * np.arange(len(t)), state, **parameters)
