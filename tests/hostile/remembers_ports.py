"""Writes a number into the network's memory: a port that was connected rests for a minute, whoever connected it.

Each submission has processes and files of its own; a network that several share would carry a note from one to the
next, and from a call to the file's next import, whose error message the student reads.

deserves: 10
"""

import socket

FIRST = 30_000
for family in (socket.AF_INET, socket.AF_INET6, socket.AF_UNIX):
    try:
        with socket.socket(family, socket.SOCK_STREAM) as server:
            server.bind(("", FIRST) if family != socket.AF_UNIX else "\0tam570-was-here")
            server.listen()
        raise SystemExit("written")
    except OSError:
        pass
