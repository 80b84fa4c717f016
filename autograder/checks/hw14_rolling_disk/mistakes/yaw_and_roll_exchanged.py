"""Yaw and roll are exchanged in R.

fails: matrix_state_places_the_disk, wireframe_is_a_rolling_disk
also: yaw and roll are exchanged
"""

_placed = matrix_state


def matrix_state(state, *, radius):
    x, y, yaw, tilt, roll, *rates = state
    return _placed([x, y, roll, tilt, yaw, *rates], radius=radius)
