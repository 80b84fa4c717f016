"""The axis is the longest cross product of rows of R - I, which loses digits where R - I is small.

fails: small_angles_keep_their_digits
names: holds for your axis
numerics: eight digits of sixteen where R - I is 1e-8
"""

_right_axis_angle = axis_angle


def axis_angle(R):
    n, angle = _right_axis_angle(R)
    if not 0 < angle < math.pi:
        return n, angle
    rows = (R - np.eye(3)) / np.abs(R - np.eye(3)).max()
    m = max((np.cross(rows[i], rows[j]) for i, j in ((0, 1), (1, 2), (2, 0))), key=np.linalg.norm)
    return math.copysign(1, m @ n) * m / np.linalg.norm(m), angle
