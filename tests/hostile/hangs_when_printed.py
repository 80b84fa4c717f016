"""Raises an exception whose text takes for ever, and one whose text is 100 MB.

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
