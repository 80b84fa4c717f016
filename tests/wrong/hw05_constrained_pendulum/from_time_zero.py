"""The given state taken for that at t = 0.

fails: without_gravity_it_goes_round_uniformly, with_gravity_it_swings_or_goes_round
suspect: taken for that at t = 0
"""

_right_simulate = simulate


def simulate(t, state, **parameters):
    back = state * [1, 1, -1, -1]
    rows = [_right_simulate(np.array([0.0, abs(one)]), state if one > 0 else back, **parameters)[1] for one in t]
    return np.array(rows) * np.where(t[:, None] > 0, 1, [1, 1, -1, -1])
