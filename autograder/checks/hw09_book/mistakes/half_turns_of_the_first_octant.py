"""The axis of a half turn has lost its signs, so that no component is negative.

fails: half_turns_have_their_axis
"""

_right_axis_angle = axis_angle


def axis_angle(R):
    n, angle = _right_axis_angle(R)
    return np.abs(n) if np.abs(R - R.T).max() < 1e-14 else n, angle
