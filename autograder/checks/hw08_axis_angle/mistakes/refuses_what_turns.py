"""Every axis is refused, unless the angle is 0.

fails: matrix_turns_by_the_right_hand_rule, vector_turns_by_the_right_hand_rule
names: rotation_matrix raised ValueError
"""

def rotation_matrix(axis, angle):
    if angle or not np.all(np.isfinite(axis)) or not np.any(axis):
        raise ValueError("no axis")
    return np.eye(3)


def rotate(r, axis, angle):
    return rotation_matrix(axis, angle) @ r
