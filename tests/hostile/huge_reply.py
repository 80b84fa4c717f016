"""Announces a reply of 4 GiB.

deserves: 9
"""

import os


def skew(v):
    os.write(3, b"\xff\xff\xff\xff" + b"x" * 100000)
    return [[0] * 3] * 3
