"""The angle is only an arccos of the trace, which loses half of its digits.

fails: small_angles_keep_their_digits, angles_near_pi_keep_their_digits, half_turns_have_their_axis
"""

_right_axis_angle = axis_angle


def axis_angle(R):
    return _right_axis_angle(R)[0], math.acos(np.clip((np.trace(R) - 1) / 2, -1, 1))
