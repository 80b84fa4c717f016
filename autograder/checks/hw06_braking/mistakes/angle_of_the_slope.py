"""The direction by atan of left over forward: half of all directions, none on the spot.

fails: friction_in_any_motion_and_at_rest, mechanics_refuses_other_axles
suspect: atan of left over forward
"""

_right = friction_force


def friction_force(state, locked, **car):
    if state[3] == 0.0:
        return np.zeros(2)
    return _right(state, locked, **car) * np.sign(state[3])
