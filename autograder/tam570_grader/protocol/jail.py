"""The jail of one submission: namespaces of its own, limits, another user, no capabilities.

    monitor          forks one sandbox process after another, each into namespaces of its own, and holds the leash
    sandbox process  confines itself, then serves calls to the student's functions; process 1 of its namespace

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
import sys
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from .refusals import CALLS, LIBC, refuse_calls

HELD = ctypes.PyDLL(None, use_errno=True)  # the C library, whose calls keep Python's lock: a fork must
NO = (ctypes.c_long(0),) * 4  # stack, and places for numbers, of a clone that is a fork
NEW_MOUNTS, NEW_IPC, NEW_USER, NEW_PROCESSES = 0x20000, 0x8000000, 0x10000000, 0x20000000
# mount flags; private is recursive
PRIVATE, BIND, REMOUNT, NO_PROGRAMS, NO_DEVICES, NO_SUID, READ_ONLY = 0x44000, 0x1000, 32, 8, 4, 2, 1
DIE_WITH_PARENT, DUMPABLE, SUBREAPER, NO_NEW_PRIVILEGES = 1, 4, 36, 38  # prctl options
CAPABILITY_VERSION = 0x20080522
MOST_FILES = 2**16  # that the supervisor may have open; the limit itself is endless on some systems
SCRATCH = "/scratch"  # the sandbox process's own folder; not /tmp, where Python and its packages may be
CHANNEL = 3  # its only file besides /dev/null


ORDERS = b"cek"  # that a monitor gets about its process
POLL = 0.02  # s between looks at a process that may have ended
MOMENT = 0.5  # s, in which one that was killed has ended: its memory is given back before its channel is closed
BY_TICKS, EXACT = 0, 2  # clocks of a process


@dataclass(frozen=True)
class Limits:
    """What one submission may use."""

    cpu: int  # s
    memory: int  # bytes, with what the zygote itself has
    file_size: int  # bytes, of a file and of all files together
    processes: int
    namespaces: bool
    user: int | None  # the id to change to, under root
    hidden: Sequence[str] = ()  # modules that are off limits

    @property
    def refusals(self) -> dict[str, bool]:
        """What a filter of system calls has to refuse where there are no namespaces, nor a limit of processes."""
        return {"signals": not self.namespaces, "forks": not self.namespaces and self.processes == 1}


def secede(limits: Limits) -> None:
    """Leave the zygote's namespaces; without root, as root of a user namespace of our own. No process is seen there."""
    flags = NEW_MOUNTS | NEW_IPC
    if limits.user is not None:
        _must(LIBC.unshare(flags), "unshare")
    else:
        user, group = os.getuid(), os.getgid()
        LIBC.prctl(DUMPABLE, 1, 0, 0, 0)  # the maps below belong to root while we are not dumpable
        _must(LIBC.unshare(flags | NEW_USER), "unshare")
        for name, line in (("setgroups", "deny"), ("uid_map", f"{user} {user} 1"), ("gid_map", f"{group} {group} 1")):
            with open(f"/proc/self/{name}", "w") as file:
                file.write(line)
        hidden_from_debuggers()
    _must(LIBC.mount(b"none", b"/", None, PRIVATE, None), "mount /")
    _must(LIBC.mount(b"empty", b"/proc", b"tmpfs", READ_ONLY, b"size=0"), "mount /proc")
    _protect("/dev")


def fork(limits: Limits) -> int:
    """Fork as os.fork does; where there are namespaces, into new ones."""
    if not limits.namespaces:
        return os.fork()
    clone = ctypes.c_long(CALLS[platform.machine()].clone)
    flags = ctypes.c_ulong(NEW_MOUNTS | NEW_IPC | NEW_PROCESSES | signal.SIGCHLD)
    ctypes.pythonapi.PyOS_BeforeFork()
    child: int = HELD.syscall(clone, flags, *NO)
    if child == 0:
        ctypes.pythonapi.PyOS_AfterFork_Child()
    else:
        ctypes.pythonapi.PyOS_AfterFork_Parent()
        _must(min(child, 0), "clone")
    return child


def confine(limits: Limits, channel: int, folder: str) -> None:
    """Make this the sandbox process: its own file system, one channel, limits, no privilege."""
    _only(channel)
    os.setsid()  # a signal to one's own process group would reach the zygote
    if limits.namespaces:
        _own_files(limits)
    else:
        os.chdir(folder)
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
        refuse_calls(**limits.refusals)


def hidden_from_debuggers() -> None:
    """No other process of the same user may read this one's memory."""
    if hasattr(LIBC, "prctl"):
        LIBC.prctl(DUMPABLE, 0, 0, 0, 0)


def watch(child: int, leash: socket.socket, lifeline: int, limits: Limits) -> None:
    """Until the sandbox process ends: answer b"c" with its CPU seconds; kill it on b"k" or when the leash is dropped.

    On b"e" it is killed where it does not end by itself in a moment: it has closed its channel, and may have died.
    It is killed too when the lifeline, a pipe that the zygote holds the other end of, says that the zygote has died.

    The last message on the leash is "cpu stranger": the CPU seconds used, and 1 if it was killed with its zygote, or
    neither by us nor by its own limit. The kernel keeps that limit by ticks: who sleeps between them is charged whole
    ones for a little of each.
    """
    group = not limits.namespaces
    if group and hasattr(LIBC, "prctl"):
        LIBC.prctl(SUBREAPER, 1, 0, 0, 0)
    until, ours, charged, ended = float("inf"), False, 0.0, 0
    while not ended:
        ready, _, _ = select.select([leash.fileno(), lifeline], [], [], POLL)
        order = leash.recv(1) if leash.fileno() in ready else b"" if ready else None
        if order == b"c":
            _tell(leash, f"{_cpu_seconds(child):.6f}\n")
        elif order is not None:
            until = time.monotonic() + (MOMENT if order == b"e" else 0.0)
        if ours := time.monotonic() >= until:
            _kill(child, group)
        how = 0 if ours else os.WNOHANG
        if not hasattr(os, "waitid") or os.waitid(os.P_PID, child, os.WEXITED | os.WNOWAIT | how):
            charged = _cpu_seconds(child, BY_TICKS)  # the clock of one that has ended goes when it is reaped
            ended, status, usage = os.wait4(child, how)
    _reap(group)
    cpu = usage.ru_utime + usage.ru_stime
    by_another = not ours and max(cpu, charged) < limits.cpu - 0.5
    stranger = status == signal.SIGKILL and (lifeline in ready or by_another)
    _tell(leash, f"{cpu:.6f} {int(stranger)}\n")


def _kill(child: int, group: bool) -> None:
    if group:
        with contextlib.suppress(OSError):  # it has not made its group yet, or has gone
            os.killpg(child, signal.SIGKILL)
    os.kill(child, signal.SIGKILL)


def _reap(group: bool) -> None:
    """Kill what the sandbox process left behind; in a process namespace the kernel has done so."""
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


def _cpu_seconds(pid: int, clock: int = EXACT) -> float:
    try:
        # as clock_getcpuclockid(3) makes the number of a process's clock
        return time.clock_gettime((~pid << 3) | clock)
    except OSError:
        return 0.0


def _own_files(limits: Limits) -> None:
    """Enter a scratch folder of our own, without sight of what is off limits."""
    scratch = f"size={limits.file_size},nr_inodes=1000,mode=1777".encode()
    _must(LIBC.mount(b"scratch", SCRATCH.encode(), b"tmpfs", NO_SUID | NO_DEVICES, scratch), f"mount {SCRATCH}")
    for name in limits.hidden:
        _hide(name)
    os.chdir(SCRATCH)


def _protect(folder: str) -> None:
    """Make each mount in a folder read only: the times of the system's own devices would be a note to all."""
    for path in (os.path.join(folder, name) for name in os.listdir(folder)):
        if os.path.ismount(path):
            mount_flags = os.statvfs(path).f_flag & (NO_PROGRAMS | NO_DEVICES | NO_SUID)
            flags = REMOUNT | BIND | READ_ONLY | mount_flags
            _must(LIBC.mount(None, path.encode(), None, flags, None), f"protect {path}")


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
    _at_most(resource.RLIMIT_CPU, limits.cpu, "s of processor time")
    for what, most in ((resource.RLIMIT_FSIZE, limits.file_size), (resource.RLIMIT_NOFILE, 64)):
        _at_most(what, most)
    _at_most(resource.RLIMIT_CORE, 0)
    if sys.platform == "linux":  # elsewhere address space is not limited, or far beyond what is used
        _at_most(resource.RLIMIT_AS, limits.memory, "bytes of memory")
    if limits.namespaces or limits.user is not None:  # else all processes of the teacher would count
        _at_most(resource.RLIMIT_NPROC, limits.processes)


def _at_most(what: int, most: int, expected: str = "") -> None:
    """Set a limit; where the teacher's own is lower, that is kept, unless a submission was promised more."""
    try:
        resource.setrlimit(what, (most, most))
    except ValueError:
        hard = resource.getrlimit(what)[1]
        if expected:
            raise OSError(
                f"a submission may use {most} {expected}, and this shell's own limit is {hard}: "
                "raise it (ulimit -H), or allow submissions less"
            ) from None
        resource.setrlimit(what, (hard, hard))


def address_space() -> int:
    """Bytes of address space in use; 0 where the system does not tell."""
    try:
        size = os.open("/proc/self/statm", os.O_RDONLY)
    except OSError:
        return 0
    try:
        return int(os.read(size, 100).split()[0]) * resource.getpagesize()
    finally:
        os.close(size)


class _Header(ctypes.Structure):
    _fields_ = [("version", ctypes.c_uint32), ("pid", ctypes.c_int)]


def _no_capabilities() -> None:
    _must(LIBC.capset(ctypes.byref(_Header(CAPABILITY_VERSION, 0)), ctypes.byref((ctypes.c_uint32 * 6)())), "capset")


def _must(result: int, what: str) -> None:
    if result != 0:
        raise OSError(ctypes.get_errno(), f"{what}: {os.strerror(ctypes.get_errno())}")
