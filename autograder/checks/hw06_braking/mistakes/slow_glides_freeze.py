"""Below 1 cm/s the car counts as stopped, even without friction to stop it.

fails: simulate_glides_without_friction
"""

_right = simulate


def simulate(t, state, locked, **car):
    if math.hypot(state[3], _axles(locked, car["front"], car["rear"])[1] * state[4]) < 1e-2:
        return np.tile(state, (len(t), 1))
    return _right(t, state, locked, **car)
