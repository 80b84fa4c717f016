"""The particle goes round the other way, as its velocity comes from a speed without sign.

fails: without_gravity_it_goes_round_uniformly, with_gravity_it_swings_or_goes_round
"""

_right = simulate


def simulate(t, state, **known):
    x, y, vx, vy = state
    sign = -1.0 if x * vy - y * vx < 0 else 1.0
    return _right(t, np.array([x, y, sign * vx, sign * vy]), **known)
