"""The determinant must be 1 within 1e-6, which is too strict where R^T R is off by 9e-7 times I.

fails: what_is_no_rotation_is_refused
names: axis_angle raised ValueError for a rotation times 1 + 4.5e-7
"""

_right_rotation = _rotation


def _rotation(R):
    if abs(np.linalg.det(R) - 1) > 1e-6:
        raise ValueError
    return _right_rotation(R)
