"""The axis is the eigenvector of R for the eigenvalue 1, which two others come near for a small angle.

fails: small_angles_keep_their_digits
names: holds for your axis
"""

_right_axis_angle = axis_angle


def axis_angle(R):
    n, angle = _right_axis_angle(R)
    values, vectors = np.linalg.eig(R)
    m = np.real(vectors[:, np.argmin(abs(values - 1))])
    m /= np.linalg.norm(m)
    return (m if m @ n > 0 else -m) if 0 < angle < math.pi else n, angle
