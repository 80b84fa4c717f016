"""Returns objects that pass type checks, are equal to, less than and greater than everything, with difference zero.

Published against nbgrader (jupyter/nbgrader issue 1379: a class whose __eq__ returns True) and RELATE (inducer/relate
issue 295: an attribute is_number, a subclass of numpy.float64, a class that wins every comparison).

deserves: nothing
"""

import itertools

import numpy


class Claims:
    is_number = True
    __hash__ = None

    def __abs__(self):
        return self

    def __sub__(self, other):
        return self

    __rsub__ = __add__ = __radd__ = __mul__ = __rmul__ = __matmul__ = __rmatmul__ = __sub__

    def __eq__(self, other):
        return True

    __lt__ = __le__ = __gt__ = __ge__ = __eq__

    def __getattr__(self, name):
        return lambda *args, **kwargs: self


class Perfect(Claims, float):
    pass


class Inherits(Claims, numpy.float64):
    pass


class Zero(numpy.ndarray):
    def __array_ufunc__(self, ufunc, method, *inputs, **kwargs):
        return numpy.zeros(self.shape)

    def __array_function__(self, function, types, args, kwargs):
        return True

    def __sub__(self, other):
        return numpy.zeros(self.shape)

    __rsub__ = __matmul__ = __rmatmul__ = __sub__


def answers(*shape):
    parts = [numpy.full(shape, one, dtype=object).tolist() for one in (Perfect(1), Inherits(1))]
    return itertools.cycle([numpy.ones(shape).view(Zero), Claims(), Perfect(1), Inherits(1), *parts])


matrices, skews, vectors = answers(3, 3), answers(3, 3), answers(3)


def skew(v):
    return next(skews)


def rotation_matrix(axis, angle):
    return next(matrices)


def rotate(r, axis, angle):
    return next(vectors)
