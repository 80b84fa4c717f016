"""1 - cos th is half of th^2 where the angle is less than a hundredth.

fails: matrix_holds_for_every_angle
names: the cosine is not
"""

def rotation_matrix(axis, angle):
    n = _unit(axis)
    K = skew(n)
    return np.eye(3) + np.sin(angle) * K + (angle**2 / 2 if abs(angle) < 0.01 else 1 - np.cos(angle)) * (K @ K)
