"""Reads address 0.

deserves: 9
"""

import ctypes


def skew(v):
    return ctypes.string_at(0)
