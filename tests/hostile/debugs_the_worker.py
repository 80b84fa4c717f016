"""Attaches to other processes and reads their memory.

deserves: 10
"""

import ctypes

libc = ctypes.CDLL(None)
for pid in range(2, 30):
    if libc.ptrace(16, pid, 0, 0) == 0:
        raise SystemExit("attached")
    data = (ctypes.c_char * 64)()
    pair = (ctypes.c_void_p * 2)(ctypes.addressof(data), 64)
    if libc.process_vm_readv(pid, pair, 1, pair, 1, 0) > 0:
        raise SystemExit("read")
