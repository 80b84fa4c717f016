"""Reads address 0 in one function, and ends the process in another.

Published against CoCalc's nbgrader (sagemathinc/cocalc issue 4879: a kernel that crashes ends the grading) and graders
that count an exit without an error as success (SJTU-IPADS/SkVM issue 120: no results, exit code 0, full marks).

deserves: 5
"""

import ctypes
import os


def skew(v):
    return ctypes.string_at(0)


def rotate(r, axis, angle):
    os._exit(0)
