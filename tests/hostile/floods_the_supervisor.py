"""Sends messages that need much memory to read: millions of empty lists, and huge arrays without elements.

deserves: below
"""

import struct

import numpy
import sys

msgpack = sys.modules["msgpack"]  # the grader has loaded it


def skew(v):
    flood = msgpack.packb({"value": [[]] * 2**22, "changed": False})
    with open(3, "wb", closefd=False) as channel:
        channel.write(struct.pack(">I", len(flood)) + flood)


def rotation_matrix(axis, angle):
    return numpy.empty((2**40, 0))


def rotate(r, axis, angle):
    return [numpy.empty((2**40, 0))] * 3
