"""Friction is zero below a centimetre a second, as if the car were at rest.

fails: friction_in_any_motion_and_at_rest
"""

_right = friction_force


def friction_force(state, locked, **car):
    sliding = math.hypot(state[3], _axles(locked, car["front"], car["rear"])[1] * state[4])
    return _right(state, locked, **car) * (sliding >= 1e-2)
