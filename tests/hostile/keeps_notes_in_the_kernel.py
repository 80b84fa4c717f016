"""Tries each system call that can store data in the kernel for the next submission, or memory that no limit counts.

Write hints of inodes, the page cache, counters of page faults, file watches, kernel messages, Landlock rules, and
seccomp filters.

deserves: 10
"""

import ctypes
import os
import platform

LIBC = ctypes.CDLL(None, use_errno=True)
X86 = {"fadvise": 221, "readahead": 187, "mincore": 27, "preadv2": 327, "pwritev2": 328, "syslog": 103, "splice": 275}
X86 |= {"fcntl": 72, "madvise": 28, "rusage": 98, "inotify": 294, "fanotify": 300, "ioctl": 16, "wait4": 61}
X86 |= {"seccomp": 317, "waitid": 247}
ARM = {"fadvise": 223, "readahead": 213, "mincore": 232, "preadv2": 286, "pwritev2": 287, "syslog": 116, "splice": 76}
ARM |= {"fcntl": 25, "madvise": 233, "rusage": 165, "inotify": 26, "fanotify": 262, "ioctl": 29, "wait4": 260}
ARM |= {"seccomp": 277, "waitid": 95}
CALLS = X86 if platform.machine() == "x86_64" else ARM
LANDLOCK, CACHE_STATE, ADVISE_ANOTHER = 444, 451, 440  # on every machine
NOT_REFUSED = []
PAGE = 4096


def passes(name, *arguments):
    """Note a call that is not refused: EPERM and ENOSYS are refusals."""
    ctypes.set_errno(0)
    number = CALLS.get(name, name)
    if LIBC.syscall(number, *(ctypes.c_long(one) if isinstance(one, int) else one for one in arguments)) >= 0:
        NOT_REFUSED.append(name)
    elif ctypes.get_errno() not in (1, 38):
        NOT_REFUSED.append((name, ctypes.get_errno()))


def attempts():
    room = ctypes.create_string_buffer(4 * PAGE)
    address = ctypes.addressof(room)
    aligned = ctypes.c_void_p(-(-address // PAGE) * PAGE)
    vector = ctypes.create_string_buffer((address).to_bytes(8, "little") + (16).to_bytes(8, "little"))
    with open(os.__file__, "rb") as file:
        fd = file.fileno()
        passes("fadvise", fd, 0, PAGE, 4)
        passes("readahead", fd, 0, PAGE)
        passes("preadv2", fd, vector, 1, 0, 0, 8)
        passes("mincore", aligned, PAGE, room)
        passes("madvise", aligned, PAGE, 21)
        passes("madvise", aligned, PAGE, 3)
        for command in (1024, 1026, 1035, 1036, 1037, 1038, 1031):
            passes("fcntl", fd, command, vector)
        passes("ioctl", fd, 0x80086601, room)  # the flags of a file
        passes(CACHE_STATE, fd, room, room, 0)
        passes("splice", fd, None, fd, None, 1, 2)
    passes("rusage", 0, room)
    passes("wait4", -1, None, 1, room)
    passes("waitid", 0, 0, None, 5, room)
    passes("inotify", 0)
    passes("fanotify", 0, 0)
    passes("syslog", 10, None, 0)
    passes("seccomp", 2, 0, None)
    for number in (LANDLOCK, LANDLOCK + 1, LANDLOCK + 2, ADVISE_ANOTHER, 462, 470):
        passes(number, 0, 0, 1)


attempts()
if NOT_REFUSED:
    raise SystemExit(repr(NOT_REFUSED))
