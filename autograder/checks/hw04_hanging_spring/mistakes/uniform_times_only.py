"""The first step taken for all.

fails: simulate_moves_as_it_must
suspect: the first step for all
"""

_right_simulate = simulate


def simulate(t, *start, **parameters):
    return _right_simulate(t[0] + (t[1] - t[0]) * np.arange(len(t)), *start, **parameters)
