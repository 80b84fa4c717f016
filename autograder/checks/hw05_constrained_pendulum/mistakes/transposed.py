"""The rows and columns are exchanged: solve_ivp returns (4, n).

fails: without_gravity_it_goes_round_uniformly, with_gravity_it_swings_or_goes_round
names: not an array of shape (12, 4)
"""

_right_simulate = simulate


def simulate(t, state, **parameters):
    return _right_simulate(t, state, **parameters).T
