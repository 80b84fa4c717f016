"""Returns 1 for all inputs, from a helper of all functions: each result follows from the others, as right work would.

deserves: 0
"""


def one():
    return 1.0


def skew(v):
    return [[one()] * 3] * 3


def rotation_matrix(axis, angle):
    return [[one()] * 3] * 3


def rotate(r, axis, angle):
    return [one()] * 3
