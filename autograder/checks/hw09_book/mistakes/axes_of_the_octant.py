"""An axis along a coordinate axis loses its sign.

fails: axis_and_angle_are_those_of_the_matrix
"""

_right = axis_angle


def axis_angle(R):
    n, angle = _right(R)
    return (np.abs(n), angle) if np.count_nonzero(np.abs(n) > 1e-12) == 1 else (n, angle)
