"""The axis of a half turn is divided by sin(pi) = 0, where R - R^T says nothing.

fails: half_turns_have_their_axis
"""

_right_axis_angle = axis_angle


def axis_angle(R):
    n, angle = _right_axis_angle(R)
    return (n, angle) if np.any(R != R.T) or angle == 0 else (0 * n, angle)
