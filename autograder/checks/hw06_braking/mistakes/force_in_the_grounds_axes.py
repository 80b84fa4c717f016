"""The force is given in the axes of the ground, not forward and left of the car.

fails: friction_opposes_the_sliding
"""

_right = friction_force


def friction_force(state, locked, **car):
    forward, left = _right(state, locked, **car)
    c, s = math.cos(state[2]), math.sin(state[2])
    return np.array([forward * c - left * s, forward * s + left * c])
