"""Asks the kernel for what reaches round a jail: modules, file handles, rings, page faults, programs, mounts, names.

Published against containers with more rights than they need (INGInious/INGInious issue 35: root in a
container is root outside).

deserves: 10
"""

import ctypes
import platform

libc = ctypes.CDLL(None)
CALLS = {  # numbers on x86-64
    "mount": (165, b"none", b"/scratch", b"tmpfs", 0, 0),
    "umount": (166, b"/proc", 2),
    "pivot_root": (155, b"/scratch", b"/scratch"),
    "init_module": (175, 0, 0, b""),
    "open_by_handle_at": (304, -100, (ctypes.c_char * 32)(), 0),
    "setns": (308, 0, 0),
    "bpf": (321, 0, 0, 0),
    "sethostname": (170, b"mallory", 7),
    "reboot": (169, 0, 0, 0, 0),
    "settimeofday": (164, (ctypes.c_long * 2)(0, 0), 0),
}
if platform.machine() == "x86_64":
    for name, (number, *args) in CALLS.items():
        if libc.syscall(number, *args) >= 0:
            raise SystemExit(name)
