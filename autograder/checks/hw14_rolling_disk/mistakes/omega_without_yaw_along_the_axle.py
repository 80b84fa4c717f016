"""roll' stands for the total spin, but yaw' has a part along the axle too.

fails: matrix_state_places_the_disk
"""


_placed = matrix_state


def matrix_state(state, *, radius):
    m = _placed(state, radius=radius)
    return np.concatenate([m[:12], m[12:] - state[5] * math.cos(state[3]) * m[5:12:3]])
