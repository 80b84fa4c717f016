"""The start is used at t = 0; it is the state at t[0].

fails: simulate_slides
"""

_right_simulate = simulate


def simulate(t, x, v, *, curvature, gravity):
    wire = {"curvature": curvature, "gravity": gravity}
    if t[0] < 0:
        x, v = _right_simulate(np.array([0.0, -t[0]]), x, -v, **wire)[1] * [1, -1]
    elif t[0] > 0:
        x, v = _right_simulate(np.array([0.0, t[0]]), x, v, **wire)[1]
    return _right_simulate(t, x, v, **wire)
