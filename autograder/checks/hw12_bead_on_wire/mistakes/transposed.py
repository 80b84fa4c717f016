"""The rows and columns are exchanged: solve_ivp returns (2, n).

fails: simulate_slides
names: not an array of shape (1000, 2)
"""

_right_simulate = simulate


def simulate(t, x, v, *, curvature, gravity):
    return _right_simulate(t, x, v, curvature=curvature, gravity=gravity).T
