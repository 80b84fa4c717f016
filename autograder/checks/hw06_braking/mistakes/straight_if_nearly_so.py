"""Braking with a yaw rate below a thousandth of a radian a second it goes straight.

fails: simulate_needs_no_dense_times
names: tighten rtol and atol
"""

_right = simulate


def simulate(t, state, locked, **car):
    if abs(state[4]) < 1e-3 and car["friction"] * car["gravity"] > 0:
        state = np.array([*state[:4], 0.0])
    return _right(t, state, locked, **car)
