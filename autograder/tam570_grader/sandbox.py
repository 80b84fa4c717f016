"""The supervisor's side of the sandbox: starts a warm worker, opens a cell for a submission, talks to it, ends it."""

import functools
import itertools
import json
import math
import os
import select
import shutil
import socket
import stat
import struct
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import tam570
from tam570_grader.inside.wire import Unreadable, packed, unpacked

__all__ = ["Allowance", "Cell", "CellLost", "CellTimeout", "NoSandbox", "Worker", "WorkerLost", "isolation"]

LENGTH = struct.Struct(">I")
FILE_SIZE = 2**25  # bytes a submission may write into its scratch folder
LARGEST_REPLY = 2**26  # bytes
BOOT = "import json, sys; sys.path += json.loads(sys.argv[2]); from inside.worker import main; main()"
RECONSIDER = 0.25  # s between looks at a call that is late on the wall's clock
IDLE_SHARE = 0.05  # a call that uses less than this share of a core is asleep, not slow
PATIENCE = 6  # a call may take this many times its limit in wall time on a busy machine
LOWEST_USER, USERS = 20_000, 40_000  # ids that belong to nobody, within what a container maps
SYSTEM_LINKS = ("/lib", "/lib64")  # into /usr on most systems
ENVIRONMENT = {
    "PATH": "/usr/bin:/bin", "HOME": "/tmp", "LC_ALL": "C.UTF-8", "PYTHONHASHSEED": "0",
    "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1", "MKL_NUM_THREADS": "1",  # a second thread forbids namespaces
    "MPLBACKEND": "agg", "MPLCONFIGDIR": "/tmp/matplotlib",
}  # fmt: skip

_serial = itertools.count(os.getpid() * 16)  # a user id for each worker


@dataclass(frozen=True)
class Allowance:
    """What a submission may use, as the teacher set it."""

    memory: int = 2**30  # bytes
    cpu: float = 60.0  # s, the whole submission
    call: float = 10.0  # s of CPU, one call
    processes: int = 1


class CellLost(Exception):
    """The prisoner ended in the middle of a call, or sent what is no reply."""


class NoSandbox(Exception):
    """Submissions cannot be run here; the message says what to do."""


class WorkerLost(Exception):
    """The worker itself has died, through no fault of a submission."""


class CellTimeout(Exception):
    """A call took longer than it may."""


@functools.cache
def isolation() -> str:
    """How submissions are kept apart: "bubblewrap", or "processes" where the namespaces are not to be had."""
    if sys.platform != "linux" or shutil.which("bwrap") is None:
        return "processes"
    trial = ["bwrap", "--unshare-all", "--ro-bind", "/", "/", "true"]
    works = subprocess.run(trial, capture_output=True, timeout=20, check=False).returncode == 0
    return "bubblewrap" if works else "processes"


class Worker:
    """A warm process, in bubblewrap where there is one, that forks a cell for each submission."""

    def __init__(self, preload: Sequence[str], allowance: Allowance, hidden: Sequence[Path] = ()) -> None:
        self.allowance = allowance
        self._errors = tempfile.TemporaryFile()  # noqa: SIM115  closed with the worker
        self._control, inside = socket.socketpair()
        self.limits = _limits(allowance)
        settings = {"limits": self.limits, "control": inside.fileno(), "preload": list(preload)}
        command, path = _jailed(hidden) if isolation() == "bubblewrap" else _plain()
        self._process = subprocess.Popen(
            [*command, json.dumps(settings), json.dumps(path)],
            pass_fds=[inside.fileno()], env=ENVIRONMENT, stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL, stderr=self._errors, start_new_session=True,
        )  # fmt: skip
        inside.close()
        self._ready = False

    def cell(self, cpu: float, hidden: Sequence[str] = ()) -> "Cell":
        """A new cell with nothing loaded, for so many seconds of CPU, without sight of the hidden modules."""
        self._await_ready()
        channel, prisoner_end = socket.socketpair()
        leash, guard_end = socket.socketpair()
        ends = [prisoner_end.fileno(), guard_end.fileno()]
        order = {"cpu": max(1, math.ceil(cpu)), "hidden": list(hidden)}
        try:
            socket.send_fds(self._control, [json.dumps(order).encode()], ends)
        except OSError:
            raise WorkerLost from None
        prisoner_end.close()
        guard_end.close()
        return Cell(channel, leash, self.allowance.call)

    def must_live(self) -> None:
        """Raise WorkerLost if the worker is ending or has ended."""
        try:
            self._process.wait(timeout=1)
        except subprocess.TimeoutExpired:
            return
        raise WorkerLost

    def close(self) -> None:
        """End the worker and everything in it."""
        self._control.close()
        self._process.kill()
        self._process.wait()
        self._errors.close()

    def _await_ready(self) -> None:
        if self._ready:
            return
        if self._control.recv(5) != b"ready":
            self._process.wait()
            self._errors.seek(0)
            raise RuntimeError(
                f"the sandbox did not start: {self._errors.read()[-500:].decode(errors='replace')}"
            )
        self._ready = True


class Cell:
    """One submission's prisoner: requests in, replies out, each with a limit."""

    def __init__(self, channel: socket.socket, leash: socket.socket, call_limit: float) -> None:
        self._channel, self._leash, self._limit = channel, leash, call_limit
        self._channel.setblocking(False)
        self._leash.settimeout(5)  # s; the guard answers within a few hundredths
        self._received = bytearray()
        self._waited = 0.0  # s, in earlier calls: no less than the CPU time they took
        self._cpu = 0.0  # s, when the guard was last asked
        self.guarded = True  # until the guard does not answer

    def send(self, request: Any) -> None:
        """Send a request, or raise CellLost or CellTimeout."""
        data = packed(request)
        unsent = memoryview(LENGTH.pack(len(data)) + data)
        started = time.monotonic()
        while unsent:
            if not self._ready(select.POLLOUT, self._limit):
                raise CellTimeout
            try:
                unsent = unsent[self._channel.send(unsent) :]
            except OSError:
                raise CellLost from None
        self._waited += time.monotonic() - started

    def receive(self) -> Any:
        """The next reply, or raise CellLost or CellTimeout."""
        started, patience = time.monotonic(), self._limit
        while (data := self._message()) is None:
            if self._ready(select.POLLIN, started + patience - time.monotonic()):
                self._read()
            elif self._overdue(time.monotonic() - started):
                raise CellTimeout
            else:
                patience += RECONSIDER
        self._waited += time.monotonic() - started
        try:
            return unpacked(data)
        except Unreadable:
            raise CellLost from None

    def end(self) -> float:
        """Kill the prisoner; the CPU seconds it has used. A guard that does not answer has died with its worker."""
        try:
            self._leash.sendall(b"k")
            while len(words := self._leash_line().split()) == 1:
                pass  # the answer to an earlier question
            self._cpu = float(words[1])
        except OSError:
            self.guarded, self._cpu = False, max(self._cpu, self._waited)
        self.drop()
        return self._cpu

    def drop(self) -> None:
        """Let the guard kill the prisoner, without waiting for it."""
        self._channel.close()
        self._leash.close()

    def _ready(self, event: int, seconds: float) -> bool:
        poll = select.poll()
        poll.register(self._channel, event)
        return bool(poll.poll(max(0.0, seconds) * 1000))

    def _read(self) -> None:
        try:
            chunk = self._channel.recv(2**20)
        except OSError:
            chunk = b""
        if not chunk:
            raise CellLost
        self._received += chunk

    def _message(self) -> bytes | None:
        """The first whole message received, taken out of the buffer."""
        if len(self._received) < LENGTH.size:
            return None
        (size,) = LENGTH.unpack_from(self._received)
        if size > LARGEST_REPLY:
            raise CellLost
        if len(self._received) < LENGTH.size + size:
            return None
        data = bytes(self._received[LENGTH.size : LENGTH.size + size])
        del self._received[: LENGTH.size + size]
        return data

    def _overdue(self, waited: float) -> bool:
        """Whether a call has had its CPU time, or uses none: on a busy machine its time on the wall says little."""
        try:
            self._leash.sendall(b"c")
            cpu = float(self._leash_line().split()[0])
        except (OSError, IndexError):
            return True
        idle = cpu - self._cpu < IDLE_SHARE * (self._limit if self._cpu == 0.0 else RECONSIDER)
        self._cpu = cpu
        return idle or cpu - self._waited >= self._limit or waited > PATIENCE * self._limit

    def _leash_line(self) -> str:
        line = b""
        while not line.endswith(b"\n"):
            chunk = self._leash.recv(64)
            if not chunk:
                raise OSError("the guard has gone")
            line += chunk
        return line.decode()


def _limits(allowance: Allowance) -> dict[str, Any]:
    """inside.jail.Limits, but for what comes with each cell."""
    return {
        "memory": allowance.memory,
        "file_size": FILE_SIZE,
        "processes": allowance.processes,
        "namespaces": isolation() == "bubblewrap",
        "user": LOWEST_USER + next(_serial) % USERS if os.geteuid() == 0 else None,
    }


def _python() -> list[str]:
    """The interpreter below any virtual environment, with a search path that we set."""
    return [os.path.realpath(sys._base_executable), "-s", "-S", "-P", "-B", "-c", BOOT]  # type: ignore[attr-defined]


def _site_folders() -> list[str]:
    return [folder for folder in sys.path if Path(folder).name in ("site-packages", "dist-packages")]


def _plain() -> tuple[list[str], list[str]]:
    """Command and search path of a worker without a jail."""
    path = [*_site_folders(), str(Path(tam570.__file__).parents[1]), str(Path(__file__).parent)]
    if os.geteuid() == 0:
        _must_be_readable([sys.base_prefix, *path])
    return _python(), path


def _must_be_readable(folders: Sequence[str]) -> None:
    """Under root, submissions run as a user that owns nothing: what they import must be open to everyone."""
    for folder in map(Path, folders):
        closed = [place for place in (folder, *folder.parents) if not os.stat(place).st_mode & stat.S_IXOTH]
        if closed:
            raise NoSandbox(
                f"without bubblewrap, submissions run as another user than root, who may not enter {closed[-1]}: "
                "install bubblewrap, or grade as an ordinary user"
            )


def _jailed(hidden: Sequence[Path]) -> tuple[list[str], list[str]]:
    """Command and search path of a worker in bubblewrap: it sees Python, its packages and the course's utilities."""
    sites = _site_folders()
    course, inside = Path(tam570.__file__).parent, Path(__file__).parent / "inside"
    shown = {
        folder: folder for folder in [*sites, *_python_folders(), _python()[0]] if os.path.exists(folder)
    }
    shown |= {"/opt/course/tam570": str(course), "/opt/grader/inside": str(inside)}
    binds = [(Path(target), ["--ro-bind", os.path.realpath(source)]) for target, source in shown.items()]
    masks = [
        (path, ["--tmpfs"]) for path in hidden if any(path.is_relative_to(target) for target, _ in binds)
    ]
    command = [
        "bwrap",
        "--unshare-pid",
        "--unshare-ipc",
        "--unshare-net",
        "--unshare-uts",
        "--die-with-parent",
    ]
    for target, mount in sorted(masks + binds, key=lambda entry: len(entry[0].parts)):
        for parent in reversed(target.parents[:-1]):
            command += ["--perms", "0755", "--dir", str(parent)]  # by default only root may enter it
        command += [*mount, str(target)]
    for folder in filter(os.path.islink, SYSTEM_LINKS):
        command += ["--symlink", os.readlink(folder), folder]
    command += ["--ro-bind-try", "/etc/ld.so.cache", "/etc/ld.so.cache", "--proc", "/proc", "--dev", "/dev"]
    command += ["--dir", "/tmp", "--remount-ro", "/dev", "--remount-ro", "/", "--chdir", "/", "--"]
    return [*command, *_python()], [*sites, "/opt/course", "/opt/grader"]


def _python_folders() -> list[str]:
    """Where the interpreter's own libraries and the system's are."""
    libraries = [f"{sys.base_prefix}/{name}" for name in ("lib", "lib64")]
    return [
        folder
        for folder in (*libraries, "/usr/lib", "/usr/lib64", *SYSTEM_LINKS)
        if not os.path.islink(folder)
    ]
