"""The angle is an arccos of the trace where it is not very small.

fails: small_angles_keep_their_digits
names: how flat is the cosine there
"""

_right = axis_angle


def axis_angle(R):
    axis, angle = _right(R)
    return axis, math.acos((np.trace(R) - 1) / 2) if 0.001 < angle < 1 else angle
