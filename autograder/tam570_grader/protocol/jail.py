"""Confine a submission: separate namespaces, limits, another user, no capabilities.

    monitor          forks one sandbox process after another, each into new namespaces, and watches it
    sandbox process  confines itself, then serves calls to the student's functions; process 1 of its namespace
    leash            socket by which the supervisor gives orders to the monitor

If namespaces are not available, the limits and the process group remain.
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

HELD = ctypes.PyDLL(None, use_errno=True)  # the C library, called with the GIL held, as a fork requires
NO = (ctypes.c_long(0),) * 4  # stack, and addresses of ids, of a clone that acts as a fork
NEW_MOUNTS, NEW_IPC, NEW_USER, NEW_PROCESSES = 0x20000, 0x8000000, 0x10000000, 0x20000000
# mount flags; private is recursive
PRIVATE, BIND, REMOUNT, NO_PROGRAMS, NO_DEVICES, NO_SUID, READ_ONLY = 0x44000, 0x1000, 32, 8, 4, 2, 1
DIE_WITH_PARENT, DUMPABLE, SUBREAPER, NO_NEW_PRIVILEGES = 1, 4, 36, 38  # prctl options
CAPABILITY_VERSION = 0x20080522
MOST_FILES = 2**16  # file descriptors that the supervisor may have open; some systems have no limit
SCRATCH = "/scratch"  # the sandbox process's writable folder; not /tmp, where Python and its packages may be
CHANNEL = 3  # its only file descriptor besides /dev/null


ORDERS = b"cek"  # orders to a monitor about its process: see `watch`
POLL = 0.02  # s between checks whether a process has ended
MOMENT = 0.5  # s in which a killed process ends after its channel closes; its memory is freed before
BY_TICKS, EXACT = 0, 2  # CPU clocks of a process: the kernel's ticks, and exact


@dataclass(frozen=True)
class Limits:
    """What one submission may use."""

    cpu: int  # s
    memory: int  # bytes, including the zygote's own
    file_size: int  # bytes, of each file and of all files together
    processes: int
    namespaces: bool
    user: int | None  # id to change to; only under root
    hidden: Sequence[str] = ()  # modules that are off limits

    @property
    def refusals(self) -> dict[str, bool]:
        """What the system call filter must also refuse without namespaces: signals; forks if `processes` is 1."""
        return {"signals": not self.namespaces, "forks": not self.namespaces and self.processes == 1}


def secede(limits: Limits) -> None:
    """Enter new namespaces (without root, also a user namespace) with an empty /proc and read-only mounts in /dev."""
    flags = NEW_MOUNTS | NEW_IPC
    if limits.user is not None:
        _must(LIBC.unshare(flags), "unshare")
    else:
        user, group = os.getuid(), os.getgid()
        LIBC.prctl(DUMPABLE, 1, 0, 0, 0)  # only a dumpable process may write the maps below
        _must(LIBC.unshare(flags | NEW_USER), "unshare")
        for name, line in (("setgroups", "deny"), ("uid_map", f"{user} {user} 1"), ("gid_map", f"{group} {group} 1")):
            with open(f"/proc/self/{name}", "w") as file:
                file.write(line)
        hidden_from_debuggers()
    _must(LIBC.mount(b"none", b"/", None, PRIVATE, None), "mount /")
    _must(LIBC.mount(b"empty", b"/proc", b"tmpfs", READ_ONLY, b"size=0"), "mount /proc")
    _protect("/dev")


def fork(limits: Limits) -> int:
    """Fork as os.fork does, but into new namespaces if they are available."""
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
    """Make this the sandbox process: its own scratch folder, one channel, limits, no privileges."""
    _only(channel)
    os.setsid()  # otherwise a signal to its process group would reach the zygote
    if limits.namespaces:
        scratch = f"size={limits.file_size},nr_inodes=1000,mode=1777".encode()
        _must(LIBC.mount(b"scratch", folder.encode(), b"tmpfs", NO_SUID | NO_DEVICES, scratch), f"mount {folder}")
        for name in limits.hidden:
            _hide(name)
    os.chdir(folder)
    _limit(limits)
    if limits.user is not None:
        os.setgroups([])
        os.setresgid(limits.user, limits.user, limits.user)
        os.setresuid(limits.user, limits.user, limits.user)
    if hasattr(LIBC, "prctl"):
        header, none = _Header(CAPABILITY_VERSION, 0), (ctypes.c_uint32 * 6)()
        _must(LIBC.capset(ctypes.byref(header), ctypes.byref(none)), "capset")
        LIBC.prctl(NO_NEW_PRIVILEGES, 1, 0, 0, 0)
        LIBC.prctl(DIE_WITH_PARENT, signal.SIGKILL, 0, 0, 0)
        hidden_from_debuggers()
        refuse_calls(**limits.refusals)


def hidden_from_debuggers() -> None:
    """Prevent other processes of the same user from reading this one's memory."""
    if hasattr(LIBC, "prctl"):
        LIBC.prctl(DUMPABLE, 0, 0, 0, 0)


def watch(child: int, leash: socket.socket, lifeline: int, limits: Limits) -> None:
    """Watch the sandbox process until it ends: answer b"c" with its CPU seconds; kill it on b"k" or a closed leash.

    On b"e" (the process has closed its channel, and may be ending) kill it unless it ends within MOMENT. Also kill it
    when the lifeline, a pipe whose other end is in the zygote, shows that the zygote has died.

    The last message on the leash is "cpu stranger": the CPU seconds used, and 1 if the process was killed with its
    zygote, or by neither this monitor nor its CPU limit. The kernel applies that limit by ticks; a process that sleeps
    between ticks may be charged more than it used, so the larger of both times is compared with the limit.
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
            charged = _cpu_seconds(child, BY_TICKS)  # before it is reaped: then its clock disappears
            ended, status, usage = os.wait4(child, how)
    _reap(group)
    cpu = usage.ru_utime + usage.ru_stime
    by_another = not ours and max(cpu, charged) < limits.cpu - 0.5
    stranger = status == signal.SIGKILL and (lifeline in ready or by_another)
    _tell(leash, f"{cpu:.6f} {int(stranger)}\n")


def _kill(child: int, group: bool) -> None:
    if group:
        with contextlib.suppress(OSError):  # the group does not exist yet, or no longer
            os.killpg(child, signal.SIGKILL)
    os.kill(child, signal.SIGKILL)


def _reap(group: bool) -> None:
    """Kill processes that the sandbox process left; in a PID namespace, the kernel has done so."""
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
    with contextlib.suppress(OSError):  # the supervisor may have closed the leash
        leash.sendall(line.encode())


def _cpu_seconds(pid: int, clock: int = EXACT) -> float:
    try:
        # the id of a process's clock, as in clock_getcpuclockid(3)
        return time.clock_gettime((~pid << 3) | clock)
    except OSError:
        return 0.0


def _protect(folder: str) -> None:
    """Make each mount in a folder read-only: submissions could exchange data by the times of the system's devices."""
    for path in (os.path.join(folder, name) for name in os.listdir(folder)):
        if os.path.ismount(path):
            mount_flags = os.statvfs(path).f_flag & (NO_PROGRAMS | NO_DEVICES | NO_SUID)
            flags = REMOUNT | BIND | READ_ONLY | mount_flags
            _must(LIBC.mount(None, path.encode(), None, flags, None), f"protect {path}")


def _hide(module: str) -> None:
    """Mount something empty over a module, so that no way around a ban can import or read it."""
    for folder in sys.path:
        path = os.path.join(folder, *module.split(".")).encode()
        if os.path.isdir(path):
            _must(LIBC.mount(b"empty", path, b"tmpfs", READ_ONLY, b"size=0"), f"mount over {module}")
        if os.path.isfile(path + b".py"):
            _must(LIBC.mount(os.devnull.encode(), path + b".py", None, BIND, None), f"mount over {module}")


def _only(channel: int) -> None:
    """Close all file descriptors except the channel, which becomes CHANNEL; open /dev/null as stdin, stdout, stderr."""
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
    if sys.platform == "linux":  # elsewhere, it is not limited, or much larger than the memory in use
        _at_most(resource.RLIMIT_AS, limits.memory, "bytes of memory")
    if limits.namespaces or limits.user is not None:  # else the user's other processes would count
        _at_most(resource.RLIMIT_NPROC, limits.processes)


def _at_most(what: int, most: int, expected: str = "") -> None:
    """Set a limit; if the shell's limit is lower, keep that, or raise OSError if `expected` (a unit) is given."""
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
    """Return the bytes of address space in use; 0 if the system does not report it."""
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


def _must(result: int, what: str) -> None:
    if result != 0:
        raise OSError(ctypes.get_errno(), f"{what}: {os.strerror(ctypes.get_errno())}")
