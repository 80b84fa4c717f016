"""The axis comes from R - R^T, which is lost near pi.

fails: angles_near_pi_keep_their_digits
names: which part of R is large there
"""

_right = axis_angle


def axis_angle(R):
    n, angle = _right(R)
    v = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    return (v / np.linalg.norm(v) if np.linalg.norm(v) > 1e-14 else n), angle
