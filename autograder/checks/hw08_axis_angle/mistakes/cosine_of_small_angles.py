"""Cos th taken for 1 where the angle is small.

fails: matrix_holds_for_every_angle
names: the sine is right in it, the cosine is not
within: 1e-14
"""


def rotation_matrix(axis, angle):
    n = _unit(axis)
    cosine = 1.0 if abs(angle) < 1e-2 else np.cos(angle)
    return cosine * np.eye(3) + (1 - cosine) * np.outer(n, n) + np.sin(angle) * skew(n)
