"""The supervisor's connection to a sandbox process: send requests and receive replies, with time and size limits."""

import select
import socket
import time
from collections.abc import Callable
from contextlib import suppress
from typing import Any, TypeVar

from tam570_grader.protocol.wire import LENGTH, ItemBudget, Unreadable, packed, unpacked

LARGEST_REPLY = 2**26  # bytes of all replies to one request
PIECE = 2**16  # bytes per recv; a larger buffer would be requested from the system each time
SHORT = 1000  # bytes; a shorter reply takes less time to read than a query of the clock
GLANCE = 0.5  # s, longest single poll, so that a suspension of this process is noticed
RECONSIDER = 0.25  # s, longest time between checks of a call that is late in wall time
# a call that uses less than this share of a core, during the length of its time limit, is asleep
IDLE_SHARE = 0.02
PATIENCE = 6  # wall time of a call or a submission in multiples of its limit, for busy machines
T = TypeVar("T")


class ProcessLost(Exception):
    """The process ended during a call, or sent an invalid reply."""


class ProcessTimeout(Exception):
    """A call exceeded its time limit."""


class SandboxProcess:
    """A sandbox process: a channel for requests and replies, and the leash, a socket to its monitor."""

    def __init__(self, channel: socket.socket, leash: socket.socket, call_limit: float) -> None:
        self._channel, self.leash, self.limit = channel, leash, call_limit
        self._ended = False  # the process has closed its end
        self._channel.setblocking(False)
        self.leash.settimeout(60)  # s; unless the machine is busy, the monitor answers within some hundredths
        self._received = bytearray()
        self._budget, self._room = ItemBudget(), LARGEST_REPLY  # left for the replies to the current request
        self._waited = 0.0  # s of waiting in earlier calls, at least as long as their CPU time
        self.lasted = 0.0  # s, wall time of all calls, including reading their replies
        self.read = 0.0  # s, CPU time of the supervisor for reading replies
        self._cpu = 0.0  # s, CPU time at the end
        # time and CPU time when we last checked whether the CPU time grows
        self._looked_at = (0.0, 0.0)
        self._suspended = 0.0  # s in which the supervisor, or the whole machine, was suspended
        self.monitored = True  # False if the monitor does not answer at the end
        self.killed_from_outside = False  # known at the end, from the monitor
        self._final_message: list[str] = []  # the monitor's final message, after the process has ended

    def send(self, request: Any) -> None:
        """Send a request (bytes, or data to pack); raise ProcessLost or ProcessTimeout on failure."""
        data = request if isinstance(request, bytes) else packed(request)
        self._budget, self._room = ItemBudget(), LARGEST_REPLY
        unsent = memoryview(LENGTH.pack(len(data)) + data)
        sent_at, started = time.monotonic(), self._clock()
        try:
            while unsent:
                try:
                    unsent = unsent[self._channel.send(unsent) :]
                except BlockingIOError:
                    if not self._ready(select.POLLOUT, self.limit):
                        raise ProcessTimeout from None
        except OSError:
            self._ended = True
            raise ProcessLost from None
        finally:
            self.lasted += self._clock() - started
        self._waited += time.monotonic() - sent_at

    def receive(self, form: Callable[[Any], T]) -> T:
        """Return form(next reply), or raise ProcessLost or ProcessTimeout.

        The CPU time for reading the reply counts as the submission's, so that forged replies cannot delay a class.
        """
        started = self._clock()
        try:
            data = self._awaited(started)
            began = time.thread_time() if len(data) > SHORT else None
            try:
                return form(unpacked(data, self._budget))
            finally:
                self.read += time.thread_time() - began if began is not None else 0.0
        except (Unreadable, MemoryError, RecursionError):
            raise ProcessLost from None
        finally:
            self.lasted += self._clock() - started

    def _awaited(self, started: float) -> bytes:
        """Return the bytes of the next reply."""
        sent_at, patience = time.monotonic(), self.limit
        while (data := self._message()) is None:
            if self._ready(select.POLLIN, started + patience - self._clock()):
                self._read()
            elif self._overdue(started):
                raise ProcessTimeout
            else:
                patience += min(RECONSIDER, self.limit)
        self._waited += time.monotonic() - sent_at
        return data

    def seconds(self) -> float:
        """Return the CPU seconds that the process has used so far, by the kernel's clock.

        Raise ProcessLost if its monitor has ended.
        """
        try:
            self._order(b"c")
            return float(self._monitor_message()[0])
        except (OSError, IndexError):
            raise ProcessLost from None

    def end(self) -> float:
        """Kill the process and return its CPU seconds. If the monitor does not answer, it has died with its zygote."""
        try:
            self._order(b"e" if self._ended else b"k")
            self._await_final_message()
            self._cpu, self.killed_from_outside = float(self._final_message[0]), self._final_message[1] == "1"
        except OSError:
            self.monitored, self._cpu = False, max(self._cpu, self._waited)
            self.leash.close()
        self._channel.close()
        return self._cpu

    def drop(self) -> None:
        """Let the monitor kill the process, and do not wait."""
        self._order(b"k")
        self._channel.close()

    def let_go(self) -> None:
        """Close our ends of the sockets; the process ends unless another process has them open."""
        self.leash.close()
        self._channel.close()

    def has_ended(self) -> bool:
        """Return whether the process was dropped and has ended; raise OSError if its monitor has ended."""
        if self._channel.fileno() >= 0:
            return False
        if self.monitored and not self._final_message:
            said = select.poll()
            said.register(self.leash, select.POLLIN)
            if not said.poll(0):
                return False
        self._await_final_message()
        return True

    def _await_final_message(self) -> None:
        while not self._final_message:
            self._monitor_message()  # skip answers to earlier orders

    def _ready(self, event: int, seconds: float) -> bool:
        """Return whether the channel can be read or written within these seconds of `_clock`; notice suspensions."""
        poll, end = select.poll(), self._clock() + seconds
        poll.register(self._channel, event)
        while True:
            wait, started = min(max(0.0, end - self._clock()), GLANCE), time.monotonic()
            if poll.poll(wait * 1000):
                return True
            self._suspended += max(0.0, time.monotonic() - started - wait)
            if self._clock() >= end:
                return False

    def _clock(self) -> float:
        """Return seconds without suspensions: a submission that was suspended together with us is not late."""
        return time.monotonic() - self._suspended

    def _read(self) -> None:
        try:
            chunk = self._channel.recv(PIECE)
        except OSError:
            chunk = b""
        if not chunk:
            self._ended = True
            raise ProcessLost
        self._received += chunk

    def _message(self) -> bytes | None:
        """Remove and return the first complete message in the buffer; None if there is none."""
        if len(self._received) < LENGTH.size:
            return None
        (size,) = LENGTH.unpack_from(self._received)
        if size > self._room:
            raise ProcessLost
        if len(self._received) < LENGTH.size + size:
            return None
        self._room -= size
        data = bytes(self._received[LENGTH.size : LENGTH.size + size])
        del self._received[: LENGTH.size + size]
        return data

    def _overdue(self, started: float) -> bool:
        """Return whether a call has used up its CPU time, uses none, or has taken PATIENCE times its limit.

        On a busy machine, its wall time alone says little.
        """
        try:
            cpu = self.seconds()
        except ProcessLost:
            return True
        now = self._clock()
        since, cpu_then = max(self._looked_at, (started, 0.0))
        if lasted := now - since >= self.limit:
            self._looked_at = now, cpu
        idle = lasted and cpu - cpu_then < IDLE_SHARE * self.limit
        return idle or cpu - self._waited >= self.limit or now - started > PATIENCE * self.limit

    def _order(self, order: bytes) -> None:
        """Send the monitor an order; it may have ended with its process, and its final message still be unread."""
        with suppress(ConnectionError):
            self.leash.sendall(order)

    def _monitor_message(self) -> list[str]:
        """Return the words of the monitor's next message; after its final message, always those."""
        line = b""
        while not self._final_message and not line.endswith(b"\n"):
            chunk = self.leash.recv(1)
            if not chunk:
                raise OSError("the monitor has gone")
            line += chunk
        words = line.decode().split()
        self._final_message = self._final_message or (words if len(words) > 1 else [])
        return self._final_message or words
