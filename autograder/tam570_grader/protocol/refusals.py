"""What the kernel refuses a submission: a filter of system calls, which the process sets itself and cannot take off.

    refused   always
    allowed   with these values of one argument alone; any other use is refused
    absent    said not to exist: what is asked of them cannot be seen, or they are newer than this table

Refused is what outlives a process and is seen by the next, what no limit counts, and the ways to other processes. Where
a process has no namespace of its own, it may not signal others either, and, where it is to be one process, not fork.
"""

import ctypes
import platform
import struct
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache

LIBC = ctypes.CDLL(None, use_errno=True)

# fcntl: to copy a descriptor, its flags and those of the file; no locks, leases, watches and hints
FCNTL = (0, 1, 2, 3, 4, 1030)
# madvise: how memory is used; what is said of a file's pages would stay, or tell who has read them
MADVISE = (0, 1, 2, 4, 8, 10, 11, 14, 15, 16, 17)
# ioctl: whether it is a terminal, its size, bytes to be read, to wait or not, to be closed by another program
IOCTL = (0x5401, 0x5413, 0x541B, 0x5421, 0x5450, 0x5451)
# getsockopt: type, error, sizes of buffers, whether it listens, protocol, family; its cookie is a count of the kernel's
SOCKET = (3, 4, 7, 8, 30, 38, 39)
UNIX = (1,)  # other families are modules that the kernel would load, and keep
# futex: to wait, and what is private to a process; to wake others through a file that all map is a message
FUTEX = (0, 9, 265, *range(128, 142), 393)
NOTHING = (0,)
Pair = tuple[int, int | None]


@dataclass(frozen=True)
class Calls:
    """A machine's system calls, by number."""

    machine: int  # its name in the kernel's audit
    refused: Mapping[str, int]
    allowed: Mapping[str, tuple[int, int, Sequence[int]]]  # number, argument (from 0), values
    clone: int  # not with namespaces
    prctl: int  # not to set filters
    signals: Sequence[int]  # that a process sends: refused where it sees others
    forks: Sequence[int]  # besides clone


# By the same number on every machine.
COMMON = {
    **{"io_uring_setup": 425, "pidfd_getfd": 438, "process_madvise": 440, "memfd_secret": 447},
    **{"landlock_create_ruleset": 444, "landlock_add_rule": 445, "landlock_restrict_self": 446},  # uncounted memory
}
# The others by their numbers on x86_64 and on aarch64; None where a machine has no such call.
REFUSED = {
    # ways to others and to the kernel
    **{"ptrace": (101, 117), "process_vm_readv": (310, 270), "process_vm_writev": (311, 271), "bpf": (321, 280)},
    **{"perf_event_open": (298, 241), "userfaultfd": (323, 282), "unshare": (272, 97), "setns": (308, 268)},
    "seccomp": (317, 277),
    # has no namespace: keys, the kernel's messages (who crashed, and at what address)
    **{"add_key": (248, 217), "request_key": (249, 218), "keyctl": (250, 219), "syslog": (103, 116)},
    # memory that no limit counts
    **{"shmget": (29, 194), "shmat": (30, 196), "semget": (64, 190), "msgget": (68, 186), "mq_open": (240, 180)},
    **{"memfd_create": (319, 279), "io_setup": (206, 0)},
    # the ports of a zygote's network are remembered
    "socket": (41, 198),
    # a note on a file that all may read: a lock, a watch of who opens it
    **{"flock": (73, 32), "inotify_init": (253, None), "inotify_init1": (294, 26), "inotify_add_watch": (254, 27)},
    "fanotify_init": (300, 262),
    # what of a file is in memory: to put it there or to ask
    **{"fadvise64": (221, 223), "readahead": (187, 213), "mincore": (27, 232)},
    **{"splice": (275, 76), "tee": (276, 77), "vmsplice": (278, 75)},
    "getrusage": (98, 165),  # counts the pages that had to be read
    # a limit of its own would end it by a signal that looks like somebody else's
    "setrlimit": (160, 164),
    "set_robust_list": (273, 99),  # by which the kernel wakes others when it ends
}
ALLOWED = {  # the argument (from 0), and its values
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
    "futex": ((202, 98), 1, FUTEX),
}
SIGNALS = {
    **{"kill": (62, 129), "rt_sigqueueinfo": (129, 138), "tkill": (200, 130), "tgkill": (234, 131)},
    **{"rt_tgsigqueueinfo": (297, 240), "pidfd_send_signal": (424, 424)},
}
FORKS = {"fork": (57, None), "vfork": (58, None)}
OTHERS = {"clone": (56, 220), "prctl": (157, 167)}


def _calls(machine: int, which: int) -> Calls:
    """Return the calls of a machine, whose numbers are these of each pair."""

    def numbers(table: Mapping[str, Pair]) -> dict[str, int]:
        return {name: number for name, pair in table.items() if (number := pair[which]) is not None}

    allowed = {name: (pair[which], argument, values) for name, (pair, argument, values) in ALLOWED.items()}
    signals, forks = tuple(numbers(SIGNALS).values()), tuple(numbers(FORKS).values())
    return Calls(machine, numbers(REFUSED), allowed, **numbers(OTHERS), signals=signals, forks=forks)


CALLS = {"x86_64": _calls(0xC000003E, 0), "aarch64": _calls(0xC00000B7, 1)}
CLONE3 = 435  # clone is taken where it is absent
NEWER = 450  # and above: no call that this table knows; programs fall back on older ones
FOREIGN_CALLS = 0x40000000  # and above: the numbers of x32, whose calls have the name of x86-64
NAMESPACES = 0x7E020000  # flags of clone
ROBUST_LIST = 24  # bytes of its head; the one that the C library has set could be filled later
SECCOMP, FILTER = 22, 2  # of prctl

# instructions of a filter
LOAD, EQUAL, AT_LEAST, ANY_BIT, RETURN = 0x20, 0x15, 0x35, 0x45, 0x06
# where a filter finds the call, the machine, the first argument's lower half
NUMBER, MACHINE, ARGUMENTS = 0, 4, 16
STEP = struct.Struct("=HBBI")
NEXT, REFUSE, ABSENT, ALLOW = 0, -2, -1, -3  # where a comparison leads: on, or to one of the last three
PASS, FORBIDDEN, NO_SUCH_CALL = 0x7FFF0000, 0x50001, 0x50026  # what a filter returns: yes, EPERM, ENOSYS
Steps = list[tuple[int, int, int, int]]


def refuse_calls(*, signals: bool = False, forks: bool = False) -> None:
    """Have the kernel refuse what no submission needs; signals to any process, and new ones, if asked for.

    A kernel without filters takes no notice; the namespaces and the other user remain.
    """
    if data := program(signals=signals, forks=forks):
        LIBC.syscall(CALLS[platform.machine()].refused["set_robust_list"], None, ctypes.c_size_t(ROBUST_LIST))
        steps = ctypes.create_string_buffer(data)
        LIBC.prctl(SECCOMP, FILTER, ctypes.byref(_Filter(len(data) // STEP.size, ctypes.addressof(steps))), 0, 0)


@cache
def program(*, signals: bool, forks: bool) -> bytes:
    """Return the filter as the kernel reads it, or nothing; a zygote has it made before it forks for a submission."""
    if sys.platform != "linux" or sys.maxsize < 2**32 or platform.machine() not in CALLS:  # 32 bits: others
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
    """Return steps that judge a call by the lower half of an argument, and go on with any other call.

    An argument that must be nothing is a pointer, or flags of its own size: its upper half must be nothing, too.
    """
    lower = ARGUMENTS + 8 * argument
    nothing = [test[1] for test in tests] == [0]
    upper: Steps = [(LOAD, lower + 4, NEXT, NEXT), (EQUAL, 0, NEXT, REFUSE)] if nothing else []
    body: Steps = [*upper, (LOAD, lower, NEXT, NEXT), *tests, (AT_LEAST, 0, otherwise, otherwise)]
    return [(EQUAL, number, NEXT, len(body)), *body]


def _packed(steps: Steps) -> bytes:
    """Return a filter as the kernel reads it; its last three instructions are the verdicts."""
    packed = b""
    for i, (instruction, value, if_so, if_not) in enumerate(steps, start=1):
        so, no = (len(steps) + leads - i if leads < 0 else leads for leads in (if_so, if_not))
        packed += STEP.pack(instruction, so, no, value)
    return packed


class _Filter(ctypes.Structure):
    _fields_ = [("steps", ctypes.c_ushort), ("program", ctypes.c_void_p)]
