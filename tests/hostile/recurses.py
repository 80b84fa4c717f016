"""Recurses without end, with the limit lifted.

deserves: 9
"""

import sys


def skew(v):
    sys.setrecursionlimit(10**9)
    return skew(v)
