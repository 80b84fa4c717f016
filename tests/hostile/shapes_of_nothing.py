"""Returns arrays without elements whose shape encodes an input, or as lists would not fit into memory.

deserves: below
"""

import numpy


def skew(v):
    return numpy.empty((0, *(int(abs(one) * 1e6) % 2000 for one in v)))


def rotation_matrix(axis, angle):
    return numpy.empty((2**31, 2**31, 0))


def rotate(r, axis, angle):
    return numpy.empty((1999, 1999, 1999, 1, 0, 7))
