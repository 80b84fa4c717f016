"""The angle is negative where the last component of the axis would be.

fails: axis_and_angle_are_those_of_the_matrix
names: The angle is negative
"""

_right = axis_angle


def axis_angle(R):
    n, angle = _right(R)
    return (-n, -angle) if n[np.argmax(np.abs(n))] < 0 else (n, angle)
