"""The sine lacks the term th^3/6 where the angle is less than a thousandth.

fails: matrix_holds_for_every_angle
names: The cosine is right in it, the sine is not
"""

_matrix = rotation_matrix


def rotation_matrix(axis, angle):
    K = skew(_unit(axis))
    return np.eye(3) + angle * K + angle**2 / 2 * K @ K if abs(angle) < 1e-3 else _matrix(axis, angle)
