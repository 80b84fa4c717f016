"""Close to the bottom the motion is the oscillation of small amplitudes.

fails: simulate_needs_no_dense_times
within: 1e-4
"""

_right = simulate


def simulate(t, x, v, *, curvature, gravity):
    if curvature * abs(x) > 0.1 or v or not gravity:
        return _right(t, x, v, curvature=curvature, gravity=gravity)
    rate = (2 * gravity * curvature) ** 0.5
    return np.column_stack([x * np.cos(rate * (t - t[0])), -x * rate * np.sin(rate * (t - t[0]))])
