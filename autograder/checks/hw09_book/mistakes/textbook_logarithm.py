"""The axis is R - R^T over 2 sin th, the angle the length of that vector times an arccos of the trace.

fails: small_angles_keep_their_digits, angles_near_pi_keep_their_digits, half_turns_have_their_axis
names: Small angles are given as 0
numerics: half of the digits are lost near 0 and pi
"""


def axis_angle(R):
    R = _rotation(R)
    angle = math.acos(np.clip((np.trace(R) - 1) / 2, -1, 1))
    v = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    if angle == 0 or not v.any():
        return np.array([0.0, 0.0, 1.0]), angle
    v = angle * v / (2 * math.sin(angle))
    return v / np.linalg.norm(v), np.linalg.norm(v)
