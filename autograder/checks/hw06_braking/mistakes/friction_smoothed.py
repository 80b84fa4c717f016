"""Coulomb friction is smoothed where the locked axle is slower than a centimetre a second.

fails: friction_in_any_motion_and_at_rest
"""

_right = friction_force


def friction_force(state, locked, **car):
    sliding = math.hypot(state[3], _axles(locked, car["front"], car["rear"])[1] * state[4])
    return _right(state, locked, **car) * math.tanh(sliding / 1e-2)
