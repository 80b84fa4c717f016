"""omega is in body axes; it should be in the axes of space.

fails: matrix_state_places_the_disk
"""


_placed = matrix_state


def matrix_state(state, *, radius):
    m = _placed(state, radius=radius)
    return np.concatenate([m[:12], m[12:] @ m[3:12].reshape(3, 3)])
