"""Friction points backward along the car, in reverse too.

fails: friction_in_any_motion_and_at_rest
"""

_right = friction_force


def friction_force(state, locked, **car):
    force = _right(state, locked, **car)
    return np.array([-abs(force[0]), force[1]])
