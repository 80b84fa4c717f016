"""Writes messages of length zero and half a length prefix to the channel; announces a reply of 4 GiB.

Published against protocols that trust a length, or a separator, that the student's process can print
(google/tie pull request 589: the output of the tests is split at a separator).

deserves: 5
"""

import os


def skew(v):
    os.write(3, b"\x00\x00\x00\x00" * 3 + b"\xff\xff")
    return [[0.0] * 3] * 3


def rotate(r, axis, angle):
    os.write(3, b"\xff\xff\xff\xff" + b"x" * 100000)
    return [0.0] * 3
