"""The given state is treated as the state at t = 0, but it is the state at t[0].

fails: without_gravity_it_goes_round_uniformly, with_gravity_it_swings_or_goes_round
"""

_right_simulate = simulate


def simulate(t, state, **parameters):
    back = state * [1, 1, -1, -1]

    def after(time):
        if time == 0:
            return state
        return _right_simulate(np.array([0.0, abs(time)]), state if time > 0 else back, **parameters)[1]

    return np.array([after(one) for one in t]) * np.where(t[:, None] < 0, [1, 1, -1, -1], 1)
