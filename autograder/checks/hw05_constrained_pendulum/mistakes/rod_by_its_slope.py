"""The rod is drawn by its slope y/x, which loses the side and the vertical.

fails: wireframe_is_the_rod
"""


def wireframe(state, *, length):
    x, y = state[:2]
    angle = math.atan(y / x) if x else 0.0
    end = math.copysign(length, x) * np.array([math.cos(angle), math.sin(angle)])
    return np.array([[[0.0, 0.0], end]])
