"""roll' is along z; it should be along the axle.

fails: matrix_state_places_the_disk
"""

_placed = matrix_state


def matrix_state(state, *, radius):
    _, _, yaw, tilt, _, yaw_rate, tilt_rate, roll_rate = state
    omega = [tilt_rate * math.cos(yaw), tilt_rate * math.sin(yaw), yaw_rate + roll_rate]
    return np.concatenate([_placed(state, radius=radius)[:12], omega])
