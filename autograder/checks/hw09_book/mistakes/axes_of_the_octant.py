"""An axis along a coordinate axis is taken for a positive one: the sign of a sum in which there is but one term.

fails: axis_and_angle_are_those_of_the_matrix
names: a quarter turn about a coordinate axis; it points the other way
"""

_right = axis_angle


def axis_angle(R):
    n, angle = _right(R)
    return (np.abs(n), angle) if np.count_nonzero(np.abs(n) > 1e-12) == 1 else (n, angle)
