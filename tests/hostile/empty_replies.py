"""Writes a length of nothing, half a length, and a length without an end to the channel.

Published against protocols that trust a length, or a separator, that the student's process can print
(google/tie pull request 589: the output of the tests is cut at a separator).

deserves: 9
"""

import os


def skew(v):
    os.write(3, b"\x00\x00\x00\x00" * 3 + b"\xff\xff")
    return [[0.0] * 3] * 3
