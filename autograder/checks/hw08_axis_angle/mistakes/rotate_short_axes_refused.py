"""An axis shorter than 1e-9 is taken for none.

fails: vector_turns_by_every_angle
names: a very short axis
"""

_right_rotate = rotate


def rotate(r, axis, angle):
    if np.linalg.norm(axis) < 1e-9:
        raise ValueError("no axis")
    return _right_rotate(r, axis, angle)
