"""The second column is the speed along the wire, not v.

fails: simulate_slides
"""

_right_simulate = simulate


def simulate(t, x, v, *, curvature, gravity):
    states = _right_simulate(t, x, v, curvature=curvature, gravity=gravity)
    states[:, 1] *= np.hypot(1, 2 * curvature * states[:, 0])
    return states
