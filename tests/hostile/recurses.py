"""Recurses endlessly, after it raised the recursion limit.

deserves: 9
"""

import sys


def skew(v):
    sys.setrecursionlimit(10**9)
    return skew(v)
