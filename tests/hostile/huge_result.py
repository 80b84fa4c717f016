"""Returns 10^8 numbers.

deserves: 9
"""

import numpy


def skew(v):
    return numpy.zeros(10**8)
