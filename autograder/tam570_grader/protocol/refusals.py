"""A filter of system calls (seccomp), which a sandbox process sets for itself and cannot remove.

    refused   always
    allowed   only with these values of one argument; any other use is refused
    absent    reported as nonexistent: the filter cannot see their arguments, or they are newer than this table

Refused are calls whose effects outlive a process and can be seen by the next, resources that no limit counts, and
access to other processes. A process without its own namespaces is also refused signals and, if limited to one, forks.
"""

import ctypes
import platform
import struct
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache

LIBC = ctypes.CDLL(None, use_errno=True)

# fcntl: copies of a descriptor, flags of descriptor and file; no locks, leases, watches or hints
FCNTL = (0, 1, 2, 3, 4, 1030)
# madvise: use of memory; advice on a file's pages would persist, or reveal who has read them
MADVISE = (0, 1, 2, 4, 8, 10, 11, 14, 15, 16, 17)
# ioctl: is it a terminal, its size, number of readable bytes, (non)blocking, close on exec
IOCTL = (0x5401, 0x5413, 0x541B, 0x5421, 0x5450, 0x5451)
# getsockopt: type, error, buffer sizes, is it listening, protocol, family; not the cookie, a counter of the kernel
SOCKET = (3, 4, 7, 8, 30, 38, 39)
UNIX = (1,)  # for other families, the kernel would load modules and keep them
# futex: wait, and operations private to a process; waking others through a shared mapped file would be a message
FUTEX = (0, 9, 265, *range(128, 142), 393)
NOTHING = (0,)
Pair = tuple[int, int | None]


@dataclass(frozen=True)
class Calls:
    """The numbers of system calls on one architecture."""

    machine: int  # its AUDIT_ARCH
    refused: Mapping[str, int]
    allowed: Mapping[str, tuple[int, int, Sequence[int]]]  # number, argument (from 0), values
    clone: int  # refused with flags for namespaces
    prctl: int  # refused for setting filters
    signals: Sequence[int]  # calls that send signals: refused without namespaces
    forks: Sequence[int]  # besides clone


# calls with the same number on all architectures
COMMON = {
    **{"io_uring_setup": 425, "pidfd_getfd": 438, "process_madvise": 440, "memfd_secret": 447},
    **{"landlock_create_ruleset": 444, "landlock_add_rule": 445, "landlock_restrict_self": 446},  # memory without limit
}
# numbers of other calls on x86_64 and on aarch64; None if there is no such call
REFUSED = {
    # access to other processes and to the kernel
    **{"ptrace": (101, 117), "process_vm_readv": (310, 270), "process_vm_writev": (311, 271), "bpf": (321, 280)},
    **{"perf_event_open": (298, 241), "userfaultfd": (323, 282), "unshare": (272, 97), "setns": (308, 268)},
    "seccomp": (317, 277),
    # without namespaces: keys, the kernel's messages (which process crashed, at what address)
    **{"add_key": (248, 217), "request_key": (249, 218), "keyctl": (250, 219), "syslog": (103, 116)},
    # memory that no limit counts
    **{"shmget": (29, 194), "shmat": (30, 196), "semget": (64, 190), "msgget": (68, 186), "mq_open": (240, 180)},
    **{"memfd_create": (319, 279), "io_setup": (206, 0)},
    # a zygote's submissions share the ports of its network, and its names, which a socket of a pair can take, too
    **{"socket": (41, 198), "bind": (49, 200), "connect": (42, 203), "sendmsg": (46, 211), "sendmmsg": (307, 269)},
    "setsockopt": (54, 208),  # with SO_PASSCRED, sending gives a name
    # messages through a file that all can read: by a lock, by watching who opens it
    **{"flock": (73, 32), "inotify_init": (253, None), "inotify_init1": (294, 26), "inotify_add_watch": (254, 27)},
    "fanotify_init": (300, 262),
    # load pages of a file into memory, or ask which are there
    **{"fadvise64": (221, 223), "readahead": (187, 213), "mincore": (27, 232)},
    **{"splice": (275, 76), "tee": (276, 77), "vmsplice": (278, 75)},
    "getrusage": (98, 165),  # counts the pages that were read from disk
    # killed by a limit that it sets, a submission would appear to be killed from outside
    "setrlimit": (160, 164),
    "set_robust_list": (273, 99),  # lets the kernel wake other processes when this one ends
}
ALLOWED = {  # numbers, argument (from 0), its allowed values
    "fcntl": ((72, 25), 1, FCNTL),
    "ioctl": ((16, 29), 1, IOCTL),
    "madvise": ((28, 233), 2, MADVISE),
    "prlimit64": ((302, 261), 2, NOTHING),
    "preadv2": ((327, 286), 5, NOTHING),
    "pwritev2": ((328, 287), 5, NOTHING),
    "wait4": ((61, 260), 3, NOTHING),  # as getrusage
    "waitid": ((247, 95), 4, NOTHING),
    "getsockopt": ((55, 209), 2, SOCKET),
    "socketpair": ((53, 199), 0, UNIX),
    "sendto": ((44, 206), 4, NOTHING),  # no address
    "futex": ((202, 98), 1, FUTEX),
}
SIGNALS = {
    **{"kill": (62, 129), "rt_sigqueueinfo": (129, 138), "tkill": (200, 130), "tgkill": (234, 131)},
    **{"rt_tgsigqueueinfo": (297, 240), "pidfd_send_signal": (424, 424)},
}
FORKS = {"fork": (57, None), "vfork": (58, None)}
OTHERS = {"clone": (56, 220), "prctl": (157, 167)}


def _calls(machine: int, which: int) -> Calls:
    """Return the calls of an architecture, whose numbers have index `which` in the pairs."""

    def numbers(table: Mapping[str, Pair]) -> dict[str, int]:
        return {name: number for name, pair in table.items() if (number := pair[which]) is not None}

    allowed = {name: (pair[which], argument, values) for name, (pair, argument, values) in ALLOWED.items()}
    signals, forks = tuple(numbers(SIGNALS).values()), tuple(numbers(FORKS).values())
    return Calls(machine, numbers(REFUSED), allowed, **numbers(OTHERS), signals=signals, forks=forks)


CALLS = {"x86_64": _calls(0xC000003E, 0), "aarch64": _calls(0xC00000B7, 1)}
CLONE3 = 435  # absent, so that the C library uses clone
NEWER = 450  # calls from this number on are absent, so that programs use older ones
FOREIGN_CALLS = 0x40000000  # calls from this number on are x32's, with the AUDIT_ARCH of x86-64
NAMESPACES = 0x7E020000  # flags of clone
ROBUST_LIST = 24  # bytes, size of its head; resets the list of the C library, which could be filled later
SECCOMP, FILTER = 22, 2  # PR_SET_SECCOMP and its mode

# BPF instructions
LOAD, EQUAL, AT_LEAST, ANY_BIT, RETURN = 0x20, 0x15, 0x35, 0x45, 0x06
# offsets of the call's number, the architecture and the lower half of the first argument
NUMBER, MACHINE, ARGUMENTS = 0, 4, 16
STEP = struct.Struct("=HBBI")
NEXT, REFUSE, ABSENT, ALLOW = 0, -2, -1, -3  # targets of a jump: the next, or one of the last three instructions
PASS, FORBIDDEN, NO_SUCH_CALL = 0x7FFF0000, 0x50001, 0x50026  # results of a filter: allow, EPERM, ENOSYS
Steps = list[tuple[int, int, int, int]]


def refuse_calls(*, signals: bool = False, forks: bool = False) -> None:
    """Set the filter of system calls for this process, optionally also against signals and forks.

    A kernel without seccomp ignores the filter; the namespaces and the other user remain.
    """
    if data := program(signals=signals, forks=forks):
        LIBC.syscall(CALLS[platform.machine()].refused["set_robust_list"], None, ctypes.c_size_t(ROBUST_LIST))
        steps = ctypes.create_string_buffer(data)
        LIBC.prctl(SECCOMP, FILTER, ctypes.byref(_Filter(len(data) // STEP.size, ctypes.addressof(steps))), 0, 0)


@cache
def program(*, signals: bool, forks: bool) -> bytes:
    """Return the filter as BPF code, b"" if this system has none; cached: a zygote calls it before it forks."""
    if sys.platform != "linux" or sys.maxsize < 2**32 or platform.machine() not in CALLS:  # 32 bits: other numbers
        return b""
    calls = CALLS[platform.machine()]
    more = (*(calls.signals if signals else ()), *((*calls.forks, calls.clone) if forks else ()))
    return _packed(_steps(calls, more))


def _steps(calls: Calls, more: Sequence[int]) -> Steps:
    steps: Steps = [(LOAD, MACHINE, NEXT, NEXT), (EQUAL, calls.machine, NEXT, REFUSE)]
    steps += [(LOAD, NUMBER, NEXT, NEXT), (AT_LEAST, FOREIGN_CALLS, REFUSE, NEXT), (AT_LEAST, NEWER, ABSENT, NEXT)]
    steps += [(EQUAL, number, REFUSE, NEXT) for number in (*COMMON.values(), *calls.refused.values(), *more)]
    steps += [(EQUAL, CLONE3, ABSENT, NEXT)]
    for number, argument, values in calls.allowed.values():
        steps += _judged(number, argument, [(EQUAL, value, ALLOW, NEXT) for value in values], REFUSE)
    steps += _judged(calls.clone, 0, [(ANY_BIT, NAMESPACES, REFUSE, NEXT)], ALLOW)
    steps += _judged(calls.prctl, 0, [(EQUAL, SECCOMP, REFUSE, NEXT)], ALLOW)
    return [*steps, *((RETURN, verdict, NEXT, NEXT) for verdict in (PASS, FORBIDDEN, NO_SUCH_CALL))]


def _judged(number: int, argument: int, tests: Steps, otherwise: int) -> Steps:
    """Return steps that test the lower half of an argument of one call, and skip the tests for other calls.

    An argument that must be 0 may be a pointer, or flags of 64 bits: its upper half must be 0, too.
    """
    lower = ARGUMENTS + 8 * argument
    nothing = [test[1] for test in tests] == [0]
    upper: Steps = [(LOAD, lower + 4, NEXT, NEXT), (EQUAL, 0, NEXT, REFUSE)] if nothing else []
    body: Steps = [*upper, (LOAD, lower, NEXT, NEXT), *tests, (AT_LEAST, 0, otherwise, otherwise)]
    return [(EQUAL, number, NEXT, len(body)), *body]


def _packed(steps: Steps) -> bytes:
    """Return a filter as BPF code; its last three instructions return the results."""
    packed = b""
    for i, (instruction, value, if_so, if_not) in enumerate(steps, start=1):
        so, no = (len(steps) + leads - i if leads < 0 else leads for leads in (if_so, if_not))
        packed += STEP.pack(instruction, so, no, value)
    return packed


class _Filter(ctypes.Structure):
    _fields_ = [("steps", ctypes.c_ushort), ("program", ctypes.c_void_p)]
