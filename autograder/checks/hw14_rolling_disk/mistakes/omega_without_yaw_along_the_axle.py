"""The total spin in the matrix state is the roll rate.

fails: matrix_state_places_the_disk
suspect: roll' taken for the total spin
"""


_placed = matrix_state


def matrix_state(state, *, radius):
    m = _placed(state, radius=radius)
    return np.concatenate([m[:12], m[12:] - state[5] * math.cos(state[3]) * m[5:12:3]])
