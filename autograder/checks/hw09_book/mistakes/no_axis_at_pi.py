"""At a half turn, and there alone, the axis is that of R - R^T, which is zero.

fails: half_turns_have_their_axis
suspect: an axis divided by sin(pi) = 0
"""

_right_axis_angle = axis_angle


def axis_angle(R):
    n, angle = _right_axis_angle(R)
    return (n, angle) if np.any(R != R.T) or angle == 0 else (0 * n, angle)
