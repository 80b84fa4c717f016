"""Raises what ends a program, in one function each.

deserves: 5
"""

def skew(v):
    raise SystemExit(0)


def rotate(r, axis, angle):
    raise KeyboardInterrupt
