"""Changes its arguments in place so that its answer is correct for them.

deserves: 1
"""

def rotation_matrix(axis, angle):
    axis[:] = 0.0
    return [[1, 0, 0], [0, 1, 0], [0, 0, 1]]


def rotate(r, axis, angle):
    r *= 0
    return r
