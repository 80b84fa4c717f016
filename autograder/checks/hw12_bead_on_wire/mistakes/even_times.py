"""The times taken to be evenly spaced.

fails: simulate_slides
also: the times taken to be evenly spaced, the first step for all
"""

_right_simulate = simulate


def simulate(t, x, v, *, curvature, gravity):
    even = t[0] + (t[1] - t[0]) * np.arange(len(t))
    return _right_simulate(even, x, v, curvature=curvature, gravity=gravity)
