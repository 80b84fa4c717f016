"""Creates namespaces, and mounts and unmounts file systems over existing folders.

deserves: 10
"""

import ctypes
import errno
import os

libc = ctypes.CDLL(None, use_errno=True)
libc.unshare(0x10000000 | 0x20000)
clone = {"x86_64": 56, "aarch64": 220}.get(os.uname().machine)
if clone and libc.syscall(clone, 0x10000000 | 17, 0, 0, 0, 0) == 0:
    os._exit(1)
if clone and ctypes.get_errno() != errno.EPERM:  # refused by a filter, not by the limit on processes
    raise SystemExit("may make namespaces")
for place in (b"/proc", b"/tmp", b"/opt"):
    libc.mount(b"proc", place, b"proc", 0, None)
    libc.umount2(place, 2)
if os.path.exists("/proc/2"):
    raise SystemExit("sees processes")
