"""Returns an ndarray subclass whose operators all give zero.

Published against RELATE (inducer/relate issue 295: a subclass wins every comparison).

deserves: nothing
"""

import numpy


class Zero(numpy.ndarray):
    def __array_ufunc__(self, ufunc, method, *inputs, **kwargs):
        return numpy.zeros(self.shape)

    def __array_function__(self, function, types, args, kwargs):
        return True

    def __sub__(self, other):
        return numpy.zeros(self.shape)

    __rsub__ = __matmul__ = __rmatmul__ = __sub__


def skew(v):
    return numpy.ones((3, 3)).view(Zero)


def rotation_matrix(axis, angle):
    return numpy.ones((3, 3)).view(Zero)


def rotate(r, axis, angle):
    return numpy.ones(3).view(Zero)
