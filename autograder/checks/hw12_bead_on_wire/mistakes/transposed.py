"""(2, n) as solve_ivp has it.

fails: simulate_slides
names: not an array of shape (1000, 2)
"""

_right_simulate = simulate


def simulate(t, x, v, *, curvature, gravity):
    return _right_simulate(t, x, v, curvature=curvature, gravity=gravity).T
