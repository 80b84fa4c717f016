"""1 - cos th is set to half of th^2 where the angle is less than a hundredth.

fails: matrix_holds_for_every_angle
names: the cosine is not
"""

_matrix = rotation_matrix


def rotation_matrix(axis, angle):
    K = skew(_unit(axis))
    return np.eye(3) + np.sin(angle) * K + angle**2 / 2 * K @ K if abs(angle) < 1e-2 else _matrix(axis, angle)
