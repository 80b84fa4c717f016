"""Reads a counter that the whole kernel shares (socket cookies), and wakes futex waiters on a library file's page.

The next sandbox process could read the counter; one of another zygote would wake, at once or when this one ends.

deserves: 10
"""

import ctypes
import os
import platform
import socket

LIBC = ctypes.CDLL(None, use_errno=True)
LIBC.mmap.restype = ctypes.c_void_p
FUTEX, ROBUST_LIST = (202, 273) if platform.machine() == "x86_64" else (98, 99)
WAKING = {"wake": 1, "requeue": 3, "compare and requeue": 4, "wake and change": 5, "wake some": 10, "by the clock": 266}
COOKIE, PIDFD, TIPC = 57, 77, 30


def passes(attempt, *arguments):
    try:
        attempt(*arguments)
    except PermissionError:
        return False
    except OSError:
        return True
    return True


def passing():
    one, _ = socket.socketpair()
    found = [option for option in (COOKIE, PIDFD) if passes(one.getsockopt, socket.SOL_SOCKET, option, 8)]
    found += ["another family"] if passes(socket.socketpair, TIPC) else []
    with open(os.__file__, "rb") as file:
        page = ctypes.c_void_p(LIBC.mmap(None, ctypes.c_size_t(4096), 1, 1, file.fileno(), ctypes.c_long(0)))
    for name, operation in WAKING.items():
        done = LIBC.syscall(FUTEX, page, operation, 1, None, page, 1)
        found += [name] if done >= 0 or ctypes.get_errno() != 1 else []
    head = (ctypes.c_long * 3)(0, 0, page.value)  # the kernel wakes for a process that ends with locks in a list
    head[0] = ctypes.addressof(head)
    found += ["when it ends"] if LIBC.syscall(ROBUST_LIST, head, ctypes.c_size_t(24)) == 0 else []
    registered = ctypes.c_void_p()  # a list that the C library had set could be filled
    LIBC.syscall(ROBUST_LIST + 1, 0, ctypes.byref(registered), ctypes.byref(ctypes.c_size_t()))
    found += ["by the C library's list"] if registered.value else []
    return found


def as_ever():
    """Make the system calls that Python's sockets and locks need: they must work."""
    import threading

    one, other = socket.socketpair()
    one.sendall(b"x")
    assert other.recv(1) == b"x" and one.getsockopt(socket.SOL_SOCKET, socket.SO_ERROR) == 0
    socket.socket(fileno=os.dup(one.fileno())).close()
    lock = threading.Lock()
    assert lock.acquire() and not lock.acquire(timeout=0.01)


as_ever()
if found := passing():
    raise SystemExit(repr(found))
