"""The jail of one submission: namespaces of its own, limits, another user, no capabilities.

    guard    unshares namespaces, forks the prisoner, holds the leash
    prisoner confines itself, then serves calls to the student's functions; process 1 of its namespace

Where namespaces are not to be had, the limits and the process group remain.
"""

import contextlib
import ctypes
import os
import platform
import resource
import select
import signal
import socket
import struct
import sys
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

__all__ = ["SCRATCH", "Limits", "confine", "hidden_from_debuggers", "secede", "watch"]

LIBC = ctypes.CDLL(None, use_errno=True)
NEW_MOUNTS, NEW_IPC, NEW_USER, NEW_PROCESSES = 0x20000, 0x8000000, 0x10000000, 0x20000000
# mount flags; private is recursive
PRIVATE, BIND, REMOUNT, NO_PROGRAMS, NO_DEVICES, NO_SUID, READ_ONLY = 0x44000, 0x1000, 32, 8, 4, 2, 1
DIE_WITH_PARENT, DUMPABLE, SUBREAPER, NO_NEW_PRIVILEGES = 1, 4, 36, 38  # prctl options
CAPABILITY_VERSION = 0x20080522
MOST_FILES = 2**16  # that the supervisor may have open; the limit itself is endless on some systems
SCRATCH = "/scratch"  # the prisoner's own folder; not /tmp, where Python and its packages may be
CHANNEL = 3  # the prisoner's only file besides /dev/null


@dataclass(frozen=True)
class Calls:
    """A machine's system calls, by number: those that are refused, and those of which some uses are."""

    name: int  # of the machine, in the kernel's audit
    # add_key, request_key, keyctl, bpf, perf_event_open, userfaultfd, io_uring_setup, ptrace, process_vm_*,
    # pidfd_getfd;
    # shmget, shmat, semget, msgget, mq_open, memfd_create, memfd_secret, io_setup (memory that no limit counts);
    # unshare, setns; socket (a worker's network, without a device, remembers ports from one submission to the next);
    # flock (a lock on a file that all may read is a note to all); setrlimit (a limit of its own would end it by
    # a signal that looks like somebody else's)
    refused: Sequence[int]
    fcntl: int  # not for locks
    prlimit: int  # not to set any
    clone: int  # not with namespaces
    clone3: int  # says it is not there, for what it is asked cannot be seen; clone is taken then


CALLS = {
    "x86_64": Calls(
        0xC000003E,
        (248, 249, 250, 321, 298, 323, 425, 101, 310, 311, 438)
        + (29, 30, 64, 68, 240, 319, 447, 206, 272, 308, 41, 73, 160),
        fcntl=72,
        prlimit=302,
        clone=56,
        clone3=435,
    ),
    "aarch64": Calls(
        0xC00000B7,
        (217, 218, 219, 280, 241, 282, 425, 117, 270, 271, 438)
        + (194, 196, 190, 186, 180, 279, 447, 0, 97, 268, 198, 32, 164),
        fcntl=25,
        prlimit=261,
        clone=220,
        clone3=435,
    ),
}
# what fcntl is asked for locks of records and of open files, for leases
LOCKS = (5, 6, 7, 36, 37, 38, 1024, 1025)
NAMESPACES = 0x7E020000  # flags of clone
SECCOMP, FILTER = 22, 2  # of prctl
# instructions of a filter
LOAD, EQUAL, AT_LEAST, ANY_BIT, RETURN = 0x20, 0x15, 0x35, 0x45, 0x06
# where a filter finds the call, the machine, the first argument's lower half
NUMBER, MACHINE, ARGUMENTS = 0, 4, 16
NEXT, REFUSE, ABSENT = 0, -2, -1  # where a comparison leads: so many steps on, or to one of the last two
FOREIGN_CALLS = 0x40000000  # and above: the numbers of x32, whose calls have the name of x86-64
ALLOWED, FORBIDDEN, UNKNOWN = 0x7FFF0000, 0x50001, 0x50026  # what a filter returns: yes, EPERM, ENOSYS
Steps = list[tuple[int, int, int, int]]
POLL = 0.02  # s between looks at a prisoner that may have ended


@dataclass(frozen=True)
class Limits:
    """What one submission may use."""

    cpu: int  # s
    memory: int  # bytes, beyond what the worker itself has
    file_size: int  # bytes, of a file and of all files together
    processes: int
    namespaces: bool
    user: int | None  # the id to change to, under root
    hidden: Sequence[str] = ()  # modules that are off limits


def secede(limits: Limits) -> None:
    """Leave the worker's namespaces; without root, as root of a user namespace of our own."""
    flags = NEW_MOUNTS | NEW_IPC | NEW_PROCESSES
    if limits.user is not None:
        _must(LIBC.unshare(flags), "unshare")
        return
    user, group = os.getuid(), os.getgid()
    LIBC.prctl(DUMPABLE, 1, 0, 0, 0)  # the maps below belong to root while we are not dumpable
    _must(LIBC.unshare(flags | NEW_USER), "unshare")
    for name, line in (("setgroups", "deny"), ("uid_map", f"{user} {user} 1"), ("gid_map", f"{group} {group} 1")):
        with open(f"/proc/self/{name}", "w") as file:
            file.write(line)
    hidden_from_debuggers()


def confine(limits: Limits, channel: int, folder: str) -> None:
    """Make this process the prisoner: its own file system, one channel, limits, no privilege."""
    os.setsid()  # a signal to one's own process group would reach the worker
    if limits.namespaces:
        _own_files(limits)
    else:
        os.chdir(folder)
    _only(channel)
    _limit(limits)
    if limits.user is not None:
        os.setgroups([])
        os.setresgid(limits.user, limits.user, limits.user)
        os.setresuid(limits.user, limits.user, limits.user)
    if hasattr(LIBC, "prctl"):
        _no_capabilities()
        LIBC.prctl(NO_NEW_PRIVILEGES, 1, 0, 0, 0)
        LIBC.prctl(DIE_WITH_PARENT, signal.SIGKILL, 0, 0, 0)
        hidden_from_debuggers()
        _refuse_calls()


def _refuse_calls() -> None:
    """Have the kernel refuse what no submission needs: what outlives a process, what no limit counts, ways to others.

    A kernel without filters takes no notice; the namespaces and the other user remain.
    """
    if sys.platform != "linux" or sys.maxsize < 2**32 or platform.machine() not in CALLS:  # 32 bits: others
        return
    calls = CALLS[platform.machine()]
    steps: Steps = [(LOAD, MACHINE, NEXT, NEXT), (EQUAL, calls.name, NEXT, REFUSE)]
    steps += [(LOAD, NUMBER, NEXT, NEXT), (AT_LEAST, FOREIGN_CALLS, REFUSE, NEXT)]
    steps += [(EQUAL, number, REFUSE, NEXT) for number in calls.refused]
    steps += [(EQUAL, calls.clone3, ABSENT, NEXT)]
    steps += _refused_if(calls.fcntl, [_half(1)], [(EQUAL, command) for command in LOCKS])
    steps += _refused_if(calls.prlimit, [_half(2), _half(2) + 4], [(AT_LEAST, 1)])
    steps += _refused_if(calls.clone, [_half(0)], [(ANY_BIT, NAMESPACES)])
    steps += [(RETURN, verdict, NEXT, NEXT) for verdict in (ALLOWED, FORBIDDEN, UNKNOWN)]
    program = ctypes.create_string_buffer(_packed(steps))
    LIBC.prctl(SECCOMP, FILTER, ctypes.byref(_Filter(len(steps), ctypes.addressof(program))), 0, 0)


def _half(argument: int) -> int:
    """Where the lower half of a call's argument is."""
    return ARGUMENTS + 8 * argument


def _refused_if(number: int, places: Sequence[int], tests: Sequence[tuple[int, int]]) -> Steps:
    """Steps that refuse a call where one of these places passes one of the tests, and allow it elsewhere."""
    body: Steps = []
    for place in places:
        body += [(LOAD, place, NEXT, NEXT), *((test, value, REFUSE, NEXT) for test, value in tests)]
    body += [(RETURN, ALLOWED, NEXT, NEXT)]
    return [(EQUAL, number, NEXT, len(body)), *body]


def _packed(steps: Steps) -> bytes:
    """A filter as the kernel reads it; REFUSE and ABSENT are its last two instructions."""
    packed = b""
    for i, (instruction, value, if_so, if_not) in enumerate(steps, start=1):
        so, no = (len(steps) + leads - i if leads < 0 else leads for leads in (if_so, if_not))
        packed += struct.pack("=HBBI", instruction, so, no, value)
    return packed


class _Filter(ctypes.Structure):
    _fields_ = [("steps", ctypes.c_ushort), ("program", ctypes.c_void_p)]


def hidden_from_debuggers() -> None:
    """No other process of the same user may read this one's memory."""
    if hasattr(LIBC, "prctl"):
        LIBC.prctl(DUMPABLE, 0, 0, 0, 0)


def watch(prisoner: int, leash: socket.socket, lifeline: int, group: bool) -> None:
    """Until the prisoner ends: answer b"c" with its CPU seconds; kill it on b"k" or when the leash is dropped.

    It is killed too when the lifeline, a pipe that the worker holds the other end of, says that the worker has died.

    The last message on the leash is "status cpu": the wait status and the CPU seconds used.
    """
    if group and hasattr(LIBC, "prctl"):
        LIBC.prctl(SUBREAPER, 1, 0, 0, 0)
    ended = 0
    while not ended:
        ready, _, _ = select.select([leash.fileno(), lifeline], [], [], POLL)
        order = leash.recv(1) if leash.fileno() in ready else b"" if ready else None
        if order == b"c":
            _tell(leash, f"{_cpu_seconds(prisoner):.6f}\n")
        elif order is not None:
            _kill(prisoner, group)
        ended, status, usage = os.wait4(prisoner, 0 if ready and order != b"c" else os.WNOHANG)
    _reap(group)
    _tell(leash, f"{status} {usage.ru_utime + usage.ru_stime:.6f}\n")


def _kill(prisoner: int, group: bool) -> None:
    if group:
        with contextlib.suppress(OSError):  # it has not made its group yet, or has gone
            os.killpg(prisoner, signal.SIGKILL)
    os.kill(prisoner, signal.SIGKILL)


def _reap(group: bool) -> None:
    """Kill what the prisoner left behind; in a process namespace the kernel has done so."""
    while group:
        try:
            children = Path(f"/proc/self/task/{os.getpid()}/children").read_text().split()
        except OSError:
            return
        if not children:
            return
        for child in children:
            os.kill(int(child), signal.SIGKILL)
        os.wait()


def _tell(leash: socket.socket, line: str) -> None:
    with contextlib.suppress(OSError):  # nobody listens any more
        leash.sendall(line.encode())


def _cpu_seconds(pid: int) -> float:
    try:
        # the clock that clock_getcpuclockid(3) gives for a process
        return time.clock_gettime((~pid << 3) | 2)
    except OSError:
        return 0.0


def _own_files(limits: Limits) -> None:
    """A scratch folder of our own, and no view of any process."""
    _must(LIBC.mount(b"none", b"/", None, PRIVATE, None), "mount /")
    scratch = f"size={limits.file_size},nr_inodes=1000,mode=1777".encode()
    _must(LIBC.mount(b"scratch", SCRATCH.encode(), b"tmpfs", NO_SUID | NO_DEVICES, scratch), f"mount {SCRATCH}")
    _must(LIBC.mount(b"empty", b"/proc", b"tmpfs", READ_ONLY, b"size=0"), "mount /proc")
    _protect("/dev")
    for name in limits.hidden:
        _hide(name)
    os.chdir(SCRATCH)


def _protect(folder: str) -> None:
    """Make each mount in a folder read only: the times of the system's own devices would be a note to all."""
    for place in (os.path.join(folder, name) for name in os.listdir(folder)):
        if os.path.ismount(place):
            kept = os.statvfs(place).f_flag & (NO_PROGRAMS | NO_DEVICES | NO_SUID)
            flags = REMOUNT | BIND | READ_ONLY | kept
            _must(LIBC.mount(None, place.encode(), None, flags, None), f"protect {place}")


def _hide(module: str) -> None:
    """Mount something empty over a module, so that it cannot be imported or read by any way round a ban."""
    for folder in sys.path:
        path = os.path.join(folder, *module.split(".")).encode()
        if os.path.isdir(path):
            _must(LIBC.mount(b"empty", path, b"tmpfs", READ_ONLY, b"size=0"), f"mount over {module}")
        if os.path.isfile(path + b".py"):
            _must(LIBC.mount(os.devnull.encode(), path + b".py", None, BIND, None), f"mount over {module}")


def _only(channel: int) -> None:
    """Close every file but the channel, which becomes CHANNEL; input, output and errors go nowhere."""
    nowhere = os.open(os.devnull, os.O_RDWR)
    if channel != CHANNEL:
        os.dup2(channel, CHANNEL)
    for standard in range(3):
        os.dup2(nowhere, standard)
    os.closerange(CHANNEL + 1, MOST_FILES)


def _limit(limits: Limits) -> None:
    for what, most in (
        (resource.RLIMIT_CPU, limits.cpu),
        (resource.RLIMIT_FSIZE, limits.file_size),
        (resource.RLIMIT_NOFILE, 64),
        (resource.RLIMIT_CORE, 0),
    ):
        resource.setrlimit(what, (most, most))
    if sys.platform == "linux":  # elsewhere address space is not limited, or far beyond what is used
        memory = limits.memory + _address_space()
        resource.setrlimit(resource.RLIMIT_AS, (memory, memory))
    if limits.namespaces or limits.user is not None:  # else all processes of the teacher would count
        resource.setrlimit(resource.RLIMIT_NPROC, (limits.processes, limits.processes))


def _address_space() -> int:
    """Bytes of address space in use; 0 where the system does not tell."""
    try:
        with open("/proc/self/statm") as file:
            return int(file.read().split()[0]) * resource.getpagesize()
    except OSError:
        return 0


class _Header(ctypes.Structure):
    _fields_ = [("version", ctypes.c_uint32), ("pid", ctypes.c_int)]


def _no_capabilities() -> None:
    _must(LIBC.capset(ctypes.byref(_Header(CAPABILITY_VERSION, 0)), ctypes.byref((ctypes.c_uint32 * 6)())), "capset")


def _must(result: int, what: str) -> None:
    if result != 0:
        raise OSError(ctypes.get_errno(), f"{what}: {os.strerror(ctypes.get_errno())}")
