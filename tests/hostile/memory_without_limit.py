"""Asks for memory that no limit of a process counts: segments and files without a name, and namespaces to keep them in.

deserves: 10
"""

import ctypes
import mmap
import os
import platform

libc = ctypes.CDLL(None, use_errno=True)
MEMFD_SECRET, IO_SETUP, NEW_USER, NEW_NETWORK = 447, 206, 0x10000000, 0x40000000
for key in range(570, 580):
    if libc.shmget(key, 2**26, 0o1666) >= 0 or libc.msgget(key, 0o1666) >= 0:
        raise SystemExit("a segment")
try:
    file = os.memfd_create("tam570-was-here")
    os.ftruncate(file, 2**26)
    mmap.mmap(file, 2**26)
    raise SystemExit("a file without a name")
except OSError:
    pass
if platform.machine() == "x86_64":
    if libc.syscall(MEMFD_SECRET, 0) >= 0 or libc.syscall(IO_SETUP, 8, ctypes.byref(ctypes.c_ulong())) >= 0:
        raise SystemExit("asked")
if libc.unshare(NEW_USER) == 0 or libc.unshare(NEW_NETWORK) == 0:
    raise SystemExit("a namespace")
