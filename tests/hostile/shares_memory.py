"""Attaches to shared memory of other processes, and leaves shared memory, semaphores and files behind.

Published against Jobe (trampgeek/jobe pull request 48: a segment of the server with mode 666).

deserves: 10
"""

import ctypes
import os

libc = ctypes.CDLL(None, use_errno=True)
libc.shmat.restype = ctypes.c_void_p
failed = ctypes.c_void_p(-1).value
for number in range(64):
    address = libc.shmat(number, None, 0)
    if address not in (failed, None):
        raise SystemExit("shared")
libc.shmget(570, 4096, 0o1666)
libc.semget(570, 1, 0o1666)
for place in ("/dev/shm", "/dev/mqueue"):
    try:
        with open(os.path.join(place, "tam570-was-here"), "w") as file:
            file.write("here")
    except OSError:
        pass
