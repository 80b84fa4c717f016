"""The contact stands where the centre belongs.

fails: matrix_state_places_the_disk, wireframe_is_a_rolling_disk
"""


_placed = matrix_state


def matrix_state(state, *, radius):
    m = _placed(state, radius=radius)
    return [state[0], state[1], 0.0, *m[3:]]


def wireframe(state, *, radius, sides):
    m = _placed(state, radius=radius)
    angles = 2.0 * np.pi * np.arange(sides + 1) / sides
    rim = radius * np.column_stack([np.cos(angles), np.sin(angles), 0 * angles])
    ends = radius * np.eye(3)[:2]
    lines = np.concatenate([np.stack([rim[:-1], rim[1:]], axis=1), np.stack([ends, -ends], axis=1)])
    return [state[0], state[1], 0] + lines @ m[3:12].reshape(3, 3).T
