"""Attaches to other processes, opens handles to them, reads their memory and looks for their files in /proc.

Published against jobs that see each other's processes (trampgeek/jobe issue 87).

deserves: 10
"""

import ctypes
import os

libc = ctypes.CDLL(None)
PTRACE_ATTACH, PIDFD_OPEN = 16, 434
for pid in range(2, 200):
    data = (ctypes.c_char * 64)()
    pair = (ctypes.c_void_p * 2)(ctypes.addressof(data), 64)
    if libc.ptrace(PTRACE_ATTACH, pid, 0, 0) == 0 or libc.process_vm_readv(pid, pair, 1, pair, 1, 0) > 0:
        raise SystemExit("read")
    if libc.syscall(PIDFD_OPEN, pid, 0) >= 0:
        raise SystemExit("opened")
for pid in (0, 1, os.getppid(), *range(2, 50)):
    for name in ("mem", "environ", "maps", "root", "cwd", "ns/mnt"):
        if os.path.lexists(f"/proc/{pid}/{name}"):
            raise SystemExit("visible")
