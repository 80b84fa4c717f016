"""The rod is drawn by its slope y/x, and one straight up or down lies along x.

fails: wireframe_is_the_rod
names: at the bottom
"""


def wireframe(state, *, length):
    x, y = state[:2]
    angle = math.atan(y / x) if x else 0.0
    end = math.copysign(length, x) * np.array([math.cos(angle), math.sin(angle)])
    return np.array([[[0.0, 0.0], end]])
