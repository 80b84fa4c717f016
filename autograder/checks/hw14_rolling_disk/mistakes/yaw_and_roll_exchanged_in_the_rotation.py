"""Yaw and roll are exchanged in R.

fails: matrix_state_places_the_disk, wireframe_is_a_rolling_disk
"""

_placed = matrix_state


def matrix_state(state, *, radius):
    x, y, yaw, tilt, roll, *rates = state
    right, other = (_placed([x, y, *angles, *rates], radius=radius) for angles in ((yaw, tilt, roll), (roll, tilt, yaw)))
    return np.concatenate([right[:3], other[3:12], right[12:]])
