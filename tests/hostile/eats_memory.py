"""Allocates 8 GiB in one function, and returns 10^8 numbers from another.

deserves: 5
"""

import numpy


def skew(v):
    hoard = [bytearray(2**28) for _ in range(32)]
    return [[len(hoard)] * 3] * 3


def rotate(r, axis, angle):
    return numpy.zeros(10**8)
