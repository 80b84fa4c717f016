"""sin th is th where the angle is less than a hundredth.

fails: matrix_holds_for_every_angle
names: the sine is not
"""

def rotation_matrix(axis, angle):
    n = _unit(axis)
    K = skew(n)
    return np.eye(3) + (angle if abs(angle) < 0.01 else np.sin(angle)) * K + 2 * np.sin(angle / 2) ** 2 * (K @ K)
