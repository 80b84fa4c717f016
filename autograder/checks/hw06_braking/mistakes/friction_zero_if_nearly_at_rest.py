"""Friction is zero where np.allclose says that the car is at rest.

fails: friction_in_any_motion_and_at_rest
"""

_right = friction_force


def friction_force(state, locked, **car):
    return _right(state, locked, **car) * (not np.allclose(state[3:], 0))
