"""rotate reduces the angle in single precision where it is large.

fails: vector_turns_by_every_angle
names: it is that of the angle in single precision
"""


def rotate(r, axis, angle):
    if abs(angle) > 50:
        angle = np.float32(angle)
    return rotation_matrix(axis, angle) @ r
