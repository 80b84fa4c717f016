"""The times taken to be evenly spaced, the first step for all.

fails: simulate_moves_as_it_must
"""

_right_simulate = simulate


def simulate(t, *start, **parameters):
    return _right_simulate(t[0] + (t[1] - t[0]) * np.arange(len(t)), *start, **parameters)
