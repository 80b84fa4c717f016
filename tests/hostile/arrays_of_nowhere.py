"""Returns arrays of object types, of huge shapes, and of memory addresses that do not belong to the result.

Published against graders that pass the student's object to NumPy, as PrairieLearn, otter-grader and nbgrader do.

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
