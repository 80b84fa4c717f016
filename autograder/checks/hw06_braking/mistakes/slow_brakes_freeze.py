"""A car slower than a walker counts as at rest from the start, while it still has a way to go.

fails: simulate_comes_to_rest_and_stays
"""

_right = simulate


def simulate(t, state, locked, *, friction, gravity, **car):
    if abs(state[3]) < 0.3 and friction * gravity > 0 and state[3]:
        return np.tile(state, (len(t), 1))
    return _right(t, state, locked, friction=friction, gravity=gravity, **car)
