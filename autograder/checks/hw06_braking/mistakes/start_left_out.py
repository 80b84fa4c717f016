"""Row 0 is the state after the first step; it should be the start.

fails: simulate_brakes
"""

_right = simulate


def simulate(t, state, locked, **car):
    return _right(np.append(t, 2 * t[-1] - t[-2]), state, locked, **car)[1:]
