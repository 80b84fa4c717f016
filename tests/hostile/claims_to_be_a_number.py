"""Answers that pass a test of their type, and then win every comparison.

Published against RELATE (inducer/relate issue 295: an attribute is_number, and a subclass of numpy.float64).

deserves: nothing
"""

import numpy


class Claims:
    is_number = True

    def __abs__(self):
        return self

    def __rsub__(self, other):
        return self

    __sub__ = __rsub__

    def __lt__(self, other):
        return True

    __le__ = __gt__ = __ge__ = __eq__ = __lt__
    __hash__ = None


class Inherits(numpy.float64):
    is_number = True
    __abs__, __sub__, __rsub__ = Claims.__abs__, Claims.__sub__, Claims.__rsub__
    __lt__ = __le__ = __gt__ = __ge__ = __eq__ = Claims.__lt__
    __hash__ = None


def skew(v):
    return Claims()


def rotation_matrix(axis, angle):
    return [[Inherits(), Claims(), Claims()]] * 3


def rotate(r, axis, angle):
    return Inherits()
