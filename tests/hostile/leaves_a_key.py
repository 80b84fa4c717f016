"""Leaves a note for the next student in the kernel's keyrings, looks for one, and for the teacher's own keys.

Published against containers without a filter for system calls: keyrings have no namespace; rings and page
faults in the same way.

deserves: 10
"""

import ctypes
import platform

libc = ctypes.CDLL(None)
ADD_KEY, REQUEST_KEY, KEYCTL, USERFAULTFD, IO_URING_SETUP = 248, 249, 250, 323, 425
PERSISTENT = 22
if platform.machine() == "x86_64":
    for ring in (-3, -4, -5):  # of the session, the user, the user's session
        if libc.syscall(ADD_KEY, b"user", b"tam570-was-here", b"note", 4, ring) > 0:
            raise SystemExit("left")
        if libc.syscall(KEYCTL, 0, ring, 0) > 0:
            raise SystemExit("seen")
    if libc.syscall(REQUEST_KEY, b"user", b"tam570-was-here", None, 0) > 0:
        raise SystemExit("found")
    if libc.syscall(KEYCTL, PERSISTENT, -1, -3) > 0:
        raise SystemExit("lasts")
    if libc.syscall(USERFAULTFD, 1) >= 0 or libc.syscall(IO_URING_SETUP, 4, (ctypes.c_char * 120)()) >= 0:
        raise SystemExit("asked")
    if libc.syscall(0x40000000 + KEYCTL, 0, -3, 0) > 0:
        raise SystemExit("by another name")
