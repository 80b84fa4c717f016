"""You make the angle negative where the largest component of the axis is; flip both signs instead.

fails: axis_and_angle_are_those_of_the_matrix
names: Your angle is negative
"""

_right = axis_angle


def axis_angle(R):
    n, angle = _right(R)
    return (-n, -angle) if n[np.argmax(np.abs(n))] < 0 else (n, angle)
