"""Results that are views of memory that is not theirs, of types that hold objects, and of shapes that are too large.

Published against graders that hand the student's own object to NumPy, as PrairieLearn, otter-grader and nbgrader do.

deserves: 9
"""

import numpy


class Nowhere:
    def __init__(self, address, shape, kind):
        self.__array_interface__ = {"data": (address, False), "shape": shape, "typestr": kind, "version": 3}


turn = 0


def skew(v):
    global turn
    turn += 1
    odd = numpy.zeros(3, dtype=[("a", "O"), ("b", "f8")])
    strided = numpy.lib.stride_tricks.as_strided(numpy.zeros(1), (2**20, 2**20), (0, 0))
    return [odd, Nowhere(id(odd), (3, 3), "|O"), strided, Nowhere(4096, (3, 3), "<f8")][turn % 4]
