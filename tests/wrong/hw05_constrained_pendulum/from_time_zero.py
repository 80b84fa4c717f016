"""The given state taken for that at t = 0.

fails: without_gravity_it_goes_round_uniformly, with_gravity_it_swings_or_goes_round
"""

_right_simulate = simulate


def simulate(t, state, **parameters):
    if t[0] > 0:
        return _right_simulate(np.append(0.0, t), state, **parameters)[1:]
    if t[0] < 0:
        return _right_simulate(np.append(t[0] - 0.3, t), state, **parameters)[1:]
    return _right_simulate(t, state, **parameters)
