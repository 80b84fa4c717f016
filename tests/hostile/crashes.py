"""Reads address 0.

Published against CoCalc's nbgrader (sagemathinc/cocalc issue 4879: a kernel that crashes ends the grading).

deserves: 9
"""

import ctypes


def skew(v):
    return ctypes.string_at(0)
