"""The times taken as even, all as far apart as the first two.

fails: simulate_slides
suspect: evenly spaced
"""

_right_simulate = simulate


def simulate(t, x, v, *, curvature, gravity):
    even = t[0] + (t[1] - t[0]) * np.arange(len(t))
    return _right_simulate(even, x, v, curvature=curvature, gravity=gravity)
