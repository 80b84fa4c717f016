"""The force's components along x and y.

fails: friction_opposes_the_sliding
suspect: the force in the axes of the ground
"""

_right = friction_force


def friction_force(state, locked, **car):
    forward, left = _right(state, locked, **car)
    c, s = math.cos(state[2]), math.sin(state[2])
    return np.array([forward * c - left * s, forward * s + left * c])
