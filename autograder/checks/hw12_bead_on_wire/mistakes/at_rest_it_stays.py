"""A bead that starts at rest is left where it is, even on a slope.

fails: simulate_needs_no_dense_times
names: every row is the start
"""

_right = simulate


def simulate(t, x, v, *, curvature, gravity):
    found = _right(t, x, v, curvature=curvature, gravity=gravity)
    return found if v else found * 0 + [x, v]
