"""The start is put before the rows, which have it already.

fails: simulate_slides
names: Row i is the state at t[i-1]
"""

_right = simulate


def simulate(t, x, v, *, curvature, gravity):
    states = _right(t, x, v, curvature=curvature, gravity=gravity)
    return np.vstack([states[:1], states[:-1]])
