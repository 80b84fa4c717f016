"""The given state is treated as the state at t = 0, but it is the state at t[0].

fails: without_gravity_it_goes_round_uniformly, with_gravity_it_swings_or_goes_round
"""

_right_simulate = simulate


def simulate(t, state, **parameters):
    if t[0] < 0:
        raise ValueError("Values in `t_eval` are not within `t_span`.")
    return _right_simulate(np.append(0.0, t), state, **parameters)[1:]
