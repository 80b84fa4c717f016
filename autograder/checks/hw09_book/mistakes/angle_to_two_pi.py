"""The angle goes up to 2 pi, from a quaternion whose scalar part may be negative; it should stop at pi.

fails: axis_and_angle_are_those_of_the_matrix
names: The angle is larger than pi
"""

_right_axis_angle = axis_angle


def axis_angle(R):
    n, angle = _right_axis_angle(R)
    return (-n, 2 * math.pi - angle) if angle > 1.7 and n[np.argmax(np.abs(n))] < 0 else (n, angle)
