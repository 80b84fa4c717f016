"""sin th is set to th where the angle is less than a hundredth.

fails: matrix_holds_for_every_angle
names: the sine is not
"""

_matrix = rotation_matrix


def rotation_matrix(axis, angle):
    K = skew(_unit(axis))
    return np.eye(3) + angle * K + _versine(angle) * K @ K if abs(angle) < 1e-2 else _matrix(axis, angle)
