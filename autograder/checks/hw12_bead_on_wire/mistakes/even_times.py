"""The rows are at evenly spaced times, not at the times in t.

fails: simulate_slides
"""

_right_simulate = simulate


def simulate(t, x, v, *, curvature, gravity):
    even = t[0] + (t[1] - t[0]) * np.arange(len(t))
    return _right_simulate(even, x, v, curvature=curvature, gravity=gravity)
