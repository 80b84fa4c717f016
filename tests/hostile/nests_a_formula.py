"""Writes replies of lists nested up to 900 levels deep, because printing them needs recursion of the same depth.

deserves: below
"""

import struct


def deep(levels):
    nested = b"\x91" * levels + b"\xc0"
    reply = b"\x82\xa5value" + nested + b"\xa7changed\xc2"
    return struct.pack(">I", len(reply)) + reply


def write(frame):
    with open(3, "wb", closefd=False) as channel:
        channel.write(frame)


def skew(v):
    write(deep(900))


def rotation_matrix(axis, angle):
    write(deep(500))


def rotate(r, axis, angle):
    write(deep(7))
