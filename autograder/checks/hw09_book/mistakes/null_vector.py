"""The axis is the null vector of R - I by singular values, which loses digits where R - I is small.

fails: small_angles_keep_their_digits
names: holds for your axis
numerics: seven digits of sixteen where R - I is 1e-8
"""

_right_axis_angle = axis_angle


def axis_angle(R):
    n, angle = _right_axis_angle(R)
    m = np.linalg.svd(R - np.eye(3))[2][2]
    return (m if m @ n > 0 else -m) if 0 < angle < math.pi else n, angle
