"""Sends one string of 10 MB among short ones: in an array of strings, each element takes as much memory as the longest.

deserves: below
"""

import struct
import sys

msgpack = sys.modules["msgpack"]  # the grader has loaded it



def write(value):
    frame = msgpack.packb({"value": value, "changed": False})
    with open(3, "wb", closefd=False) as channel:
        channel.write(struct.pack(">I", len(frame)) + frame)


def skew(v):
    write(["x" * 10**7] + [""] * 100)


def rotation_matrix(axis, angle):
    write(["x" * 10**7] + [""] * 10**5)


def rotate(r, axis, angle):
    write([["x" * 10**7] + [""] * 10**4, b"x" * 10**7, {"a": "x" * 10**7}])
