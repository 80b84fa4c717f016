"""With only two times the second is never reached.

fails: simulate_needs_no_dense_times
names: every row is the start
"""

_right = simulate


def simulate(t, x, v, *, curvature, gravity):
    found = np.array(_right(t, x, v, curvature=curvature, gravity=gravity))
    return found if len(t) > 2 else found[[0, 0]]
