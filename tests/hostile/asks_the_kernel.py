"""Makes system calls that escape a sandbox, store data beyond a process, or take memory that no limit counts.

Kernel modules, file handles, io_uring, userfaultfd, BPF, mounts, host names; keys, which the next student or the
teacher could read because keyrings have no namespace; shared memory segments and anonymous files.
Published against containers with more rights than they need (INGInious/INGInious issue 35: root in a container is root
outside) or without a filter for system calls.

deserves: 10
"""

import contextlib
import ctypes
import mmap
import os
import platform

libc = ctypes.CDLL(None, use_errno=True)
NOTE, RINGS = b"tam570-was-here", (-3, -4, -5)  # of the session, the user, the user's session
KEYCTL, ANOTHER_TABLE, NEW_USER, NEW_NETWORK = 250, 0x40000000, 0x10000000, 0x40000000
CALLS = [  # name, number on x86-64, arguments
    ("mount", 165, b"none", b"/scratch", b"tmpfs", 0, 0),
    ("umount", 166, b"/proc", 2),
    ("pivot_root", 155, b"/scratch", b"/scratch"),
    ("init_module", 175, 0, 0, b""),
    ("open_by_handle_at", 304, -100, (ctypes.c_char * 32)(), 0),
    ("setns", 308, 0, 0),
    ("bpf", 321, 0, 0, 0),
    ("sethostname", 170, b"mallory", 7),
    ("reboot", 169, 0, 0, 0, 0),
    ("settimeofday", 164, (ctypes.c_long * 2)(0, 0), 0),
    *(("add_key", 248, b"user", NOTE, b"note", 4, ring) for ring in RINGS),
    *(("a keyring", KEYCTL, 0, ring, 0) for ring in RINGS),
    ("request_key", 249, b"user", NOTE, None, 0),
    ("a keyring that lasts", KEYCTL, 22, -1, -3),
    ("a keyring by another name", ANOTHER_TABLE + KEYCTL, 0, -3, 0),
    ("userfaultfd", 323, 1),
    ("io_uring_setup", 425, 4, (ctypes.c_char * 120)()),
    ("memfd_secret", 447, 0),
    ("io_setup", 206, 8, ctypes.byref(ctypes.c_ulong())),
]
for name, number, *args in CALLS if platform.machine() == "x86_64" else ():
    if libc.syscall(number, *args) >= 0:
        raise SystemExit(name)
for key in range(570, 580):
    if libc.shmget(key, 2**26, 0o1666) >= 0 or libc.msgget(key, 0o1666) >= 0:
        raise SystemExit("a segment")
with contextlib.suppress(OSError):
    file = os.memfd_create("tam570-was-here")
    os.ftruncate(file, 2**26)
    mmap.mmap(file, 2**26)
    raise SystemExit("a file without a name")
if libc.unshare(NEW_USER) == 0 or libc.unshare(NEW_NETWORK) == 0:
    raise SystemExit("a namespace")
