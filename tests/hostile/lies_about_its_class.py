"""Returns objects that claim to be arrays, and lists with a false length.

Published against RELATE (inducer/relate issue 295: an object that claims to be a number is accepted as a number).

deserves: 5
"""

import numpy


class Liar:
    __class__ = numpy.ndarray
    shape = (3, 3)
    dtype = numpy.dtype(float)
    ndim = 2

    def __len__(self):
        return 10**9

    def __getitem__(self, item):
        return self


class Long(list):
    def __len__(self):
        return 3

    def __iter__(self):
        while True:
            yield 0.0


def skew(v):
    return Liar()


def rotate(r, axis, angle):
    return Long([1, 2, 3])
