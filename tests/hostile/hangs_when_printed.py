"""Raises an exception whose `__str__` never returns, and an exception whose text is 100 MB long.

deserves: 5
"""

class Slow(Exception):
    def __str__(self):
        while True:
            pass


class Long(Exception):
    def __str__(self):
        return "x" * 10**8


def skew(v):
    raise Slow


def rotate(r, axis, angle):
    raise Long
