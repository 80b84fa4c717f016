"""The direction of friction comes from the arctan of left over forward, which is the same in reverse.

fails: friction_in_any_motion_and_at_rest, mechanics_refuses_other_axles
"""

_right = friction_force


def friction_force(state, locked, **car):
    if state[3] == 0.0:
        return np.zeros(2)
    return _right(state, locked, **car) * np.sign(state[3])
