"""cos th is set to 1 where the angle is less than a hundredth.

fails: matrix_holds_for_every_angle
also: For a small angle the matrix has 1 where cos th belongs
names: the cosine is not
"""

_matrix = rotation_matrix


def rotation_matrix(axis, angle):
    K = skew(_unit(axis))
    return np.eye(3) + np.sin(angle) * K + 0.0 * K @ K if abs(angle) < 1e-2 else _matrix(axis, angle)
