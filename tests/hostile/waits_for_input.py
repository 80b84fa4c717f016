"""Asks for input, by the standard input and the terminal, and starts a debugger that waits for commands.

Published against nbgrader (jupyter/nbgrader pull request 77: what reads input or starts a debugger holds up the
grading).

deserves: 5
"""

import os


def skew(v):
    open("/dev/tty").read()
    return input("? ")


def rotate(r, axis, angle):
    breakpoint()
    return os.read(0, 1)
