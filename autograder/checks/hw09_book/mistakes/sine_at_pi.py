"""The axis of a half turn is divided by sin(pi) = 0, where R - R^T says nothing.

fails: angles_near_pi_keep_their_digits, half_turns_have_their_axis
"""


def axis_angle(R):
    R = _rotation(R)
    v = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    angle = math.atan2(math.hypot(*v), np.trace(R) - 1)
    return (v / (2 * math.sin(angle)) if angle > 0 else np.array([0, 0, 1.0])), angle
