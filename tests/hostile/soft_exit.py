"""Raises SystemExit in one function and KeyboardInterrupt in another.

Published against Gradema (its page on security: early exits) and others that trust the exit code.

deserves: 5
"""

def skew(v):
    raise SystemExit(0)


def rotate(r, axis, angle):
    raise KeyboardInterrupt
