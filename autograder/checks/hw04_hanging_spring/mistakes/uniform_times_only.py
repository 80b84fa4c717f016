"""The times are treated as evenly spaced, with the first step for all.

fails: simulate_moves_as_it_must
names: evenly spaced
"""

_right_simulate = simulate


def simulate(t, *start, **parameters):
    return _right_simulate(t[0] + (t[1] - t[0]) * np.arange(len(t)), *start, **parameters)
