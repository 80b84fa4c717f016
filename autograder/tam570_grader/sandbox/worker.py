"""The supervisor's side of the sandbox: starts a warm worker, opens a cell for a submission, talks to it, ends it."""

import contextlib
import itertools
import json
import math
import os
import select
import signal
import socket
import struct
import subprocess
import tempfile
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from tam570_grader.sandbox.inside.wire import ItemBudget, Unreadable, packed, unpacked
from tam570_grader.sandbox.launch import environment, isolation, jailed_command, plain_command

__all__ = ["PATIENCE", "Allowance", "Cell", "CellLost", "CellTimeout", "Worker", "WorkerLost"]

LENGTH = struct.Struct(">I")
FILE_SIZE = 2**25  # bytes a submission may write into its scratch folder
LARGEST_REPLY = 2**26  # bytes, of all replies to one request
GLANCE = 0.5  # s of a wait in one piece
RECONSIDER = 0.25  # s between looks at a call that is late on the wall's clock
# a call that for so long as its limit uses less than this share of a core is asleep, not slow
IDLE_SHARE = 0.02
PATIENCE = 6  # a call, and a submission, may take this many times its limit in wall time on a busy machine
LOWEST_USER, USERS = 20_000, 40_000  # ids that belong to nobody, within what a container maps

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


class WorkerLost(Exception):
    """The worker itself has died, through no fault of a submission."""


class CellTimeout(Exception):
    """A call took longer than it may."""


class Worker:
    """A warm process, in bubblewrap where there is one, that forks a cell for each submission."""

    def __init__(self, preload: Sequence[str], allowance: Allowance, hidden: Sequence[Path] = ()) -> None:
        self.allowance = allowance
        self._errors = tempfile.TemporaryFile()  # noqa: SIM115  closed with the worker
        self._control, inside = socket.socketpair()
        self.limits = _limits(allowance)
        settings = {"limits": self.limits, "control": inside.fileno(), "preload": list(preload)}
        command, path = jailed_command(hidden) if isolation() == "bubblewrap" else plain_command()
        self._process = subprocess.Popen(
            [*command, json.dumps(settings), json.dumps(path)],
            pass_fds=[inside.fileno()],
            env=environment(),
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=self._errors,
            start_new_session=True,
        )
        inside.close()
        self._ready = False

    def cell(self, cpu: float, hidden: Sequence[str] = ()) -> "Cell":
        """A new cell with nothing loaded, for so many seconds of CPU, without sight of the hidden modules."""
        self._await_ready()
        channel, prisoner_end = socket.socketpair()
        leash, guard_end = socket.socketpair()
        ends = [prisoner_end.fileno(), guard_end.fileno()]
        most = max(1, math.ceil(cpu))
        order = {"cpu": most, "hidden": list(hidden)}
        try:
            socket.send_fds(self._control, [json.dumps(order).encode()], ends)
        except OSError:
            channel.close()
            leash.close()
            raise WorkerLost("the worker died") from None
        finally:
            prisoner_end.close()
            guard_end.close()
        return Cell(channel, leash, self.allowance.call, most)

    def must_live(self) -> None:
        """Raise WorkerLost if the worker is ending or has ended."""
        try:
            self._process.wait(timeout=1)
        except subprocess.TimeoutExpired:
            return
        raise WorkerLost("the worker died")

    def close(self) -> None:
        """End the worker and everything in it."""
        self._control.close()
        self.kill()
        self._process.wait()
        self._errors.close()

    def kill(self) -> None:
        """Kill the worker at once: its whole group, for a half-started bubblewrap's child outlives its parent."""
        with contextlib.suppress(ProcessLookupError, PermissionError):  # macOS refuses for one that has ended
            os.killpg(self._process.pid, signal.SIGKILL)

    def _await_ready(self) -> None:
        if self._ready:
            return
        try:
            said = self._control.recv(5)
        except OSError:
            said = b""
        if said != b"ready":
            self._process.wait()
            self._errors.seek(0)
            raise WorkerLost(f"the sandbox did not start: {self._errors.read()[-500:].decode(errors='replace')}")
        self._ready = True


class Cell:
    """One submission's prisoner: requests in, replies out, each with a limit."""

    def __init__(self, channel: socket.socket, leash: socket.socket, call_limit: float, most: int) -> None:
        self._channel, self._leash, self._limit, self._most = channel, leash, call_limit, most
        self._ended = False  # the prisoner has closed its end
        self._channel.setblocking(False)
        self._leash.settimeout(5)  # s; the guard answers within a few hundredths
        self._received = bytearray()
        self._budget, self._room = ItemBudget(), LARGEST_REPLY  # for the replies to the request before us
        self._waited = 0.0  # s, in earlier calls: no less than the CPU time they took
        self.lasted = 0.0  # s on the wall's clock, of all calls and of reading what they sent
        self._cpu = 0.0  # s, at the end
        # when we last asked for the CPU time to see whether it grows, and what it was
        self._looked_at = (0.0, 0.0)
        self._stood_still = 0.0  # s, in which this process was not run: suspended, or the whole machine was
        self.guarded = True  # until the guard does not answer
        self.killed_from_outside = False  # at the end: it was killed, and neither by us nor for its CPU time

    def send(self, request: Any) -> None:
        """Send a request, or raise CellLost or CellTimeout."""
        data = packed(request)
        self._budget, self._room = ItemBudget(), LARGEST_REPLY
        unsent = memoryview(LENGTH.pack(len(data)) + data)
        asked, started = time.monotonic(), self._clock()
        try:
            while unsent:
                if not self._ready(select.POLLOUT, self._limit):
                    raise CellTimeout
                unsent = unsent[self._channel.send(unsent) :]
        except OSError:
            self._ended = True
            raise CellLost from None
        finally:
            self.lasted += self._clock() - started
        self._waited += time.monotonic() - asked

    def receive(self) -> Any:
        """The next reply, or raise CellLost or CellTimeout."""
        started = self._clock()
        try:
            return unpacked(self._awaited(started), self._budget)
        except Unreadable:
            raise CellLost from None
        finally:
            self.lasted += self._clock() - started

    def _awaited(self, started: float) -> bytes:
        """The bytes of the next reply."""
        asked, patience = time.monotonic(), self._limit
        while (data := self._message()) is None:
            if self._ready(select.POLLIN, started + patience - self._clock()):
                self._read()
            elif self._overdue(started):
                raise CellTimeout
            else:
                patience += RECONSIDER
        self._waited += time.monotonic() - asked
        return data

    def seconds(self) -> float:
        """The CPU seconds that the prisoner has used so far, by the kernel's clock; CellLost if its guard has gone."""
        try:
            self._leash.sendall(b"c")
            return float(self._leash_line().split()[0])
        except (OSError, IndexError):
            raise CellLost from None

    def end(self) -> float:
        """Kill the prisoner; the CPU seconds it has used. A guard that does not answer has died with its worker."""
        try:
            self._leash.sendall(b"k")
            while len(words := self._leash_line().split()) == 1:
                pass  # the answer to an earlier question
            self._cpu = float(words[1])
            self.killed_from_outside = self._ended and int(words[0]) == signal.SIGKILL and self._cpu < self._most - 0.5
        except OSError:
            self.guarded, self._cpu = False, max(self._cpu, self._waited)
        self.drop()
        return self._cpu

    def drop(self) -> None:
        """Let the guard kill the prisoner, without waiting for it."""
        self._channel.close()
        self._leash.close()

    def _ready(self, event: int, seconds: float) -> bool:
        """Whether it can be read or written within these seconds of our clock, which stands where a wait ends late."""
        poll, end = select.poll(), self._clock() + seconds
        poll.register(self._channel, event)
        while True:
            wait, started = min(max(0.0, end - self._clock()), GLANCE), time.monotonic()
            if poll.poll(wait * 1000):
                return True
            self._stood_still += max(0.0, time.monotonic() - started - wait)
            if self._clock() >= end:
                return False

    def _clock(self) -> float:
        """Seconds that have passed for this process: a submission that stood still with it is not late."""
        return time.monotonic() - self._stood_still

    def _read(self) -> None:
        try:
            chunk = self._channel.recv(2**20)
        except OSError:
            chunk = b""
        if not chunk:
            self._ended = True
            raise CellLost
        self._received += chunk

    def _message(self) -> bytes | None:
        """The first whole message received, taken out of the buffer."""
        if len(self._received) < LENGTH.size:
            return None
        (size,) = LENGTH.unpack_from(self._received)
        if size > self._room:
            raise CellLost
        if len(self._received) < LENGTH.size + size:
            return None
        self._room -= size
        data = bytes(self._received[LENGTH.size : LENGTH.size + size])
        del self._received[: LENGTH.size + size]
        return data

    def _overdue(self, started: float) -> bool:
        """Whether a call has had its CPU time, or uses none: on a busy machine its time on the wall says little."""
        try:
            cpu = self.seconds()
        except CellLost:
            return True
        now = self._clock()
        since, cpu_then = max(self._looked_at, (started, 0.0))
        idle = cpu - cpu_then < IDLE_SHARE * self._limit
        if now - since >= self._limit:
            self._looked_at = now, cpu
        else:
            idle = False
        return idle or cpu - self._waited >= self._limit or now - started > PATIENCE * self._limit

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
