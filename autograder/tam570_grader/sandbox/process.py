"""One submission's process, as the supervisor holds it: requests in, replies out, each with a limit."""

import select
import socket
import struct
import time
from collections.abc import Callable
from contextlib import suppress
from typing import Any, TypeVar

from tam570_grader.protocol.wire import ItemBudget, Unreadable, packed, unpacked

LENGTH = struct.Struct(">I")
LARGEST_REPLY = 2**26  # bytes, of all replies to one request
PIECE = 2**16  # bytes that are read at once; room for more would be fetched from the system each time
SHORT = 1000  # bytes of a reply, which takes less to read than to ask for the time
GLANCE = 0.5  # s of a wait in one piece
RECONSIDER = 0.25  # s at most between looks at a call that is late on the wall's clock
# a call that for so long as its limit uses less than this share of a core is asleep, not slow
IDLE_SHARE = 0.02
PATIENCE = 6  # a call, and a submission, may take this many times its limit in wall time on a busy machine
T = TypeVar("T")


class ProcessLost(Exception):
    """The process ended in the middle of a call, or sent what is no reply."""


class ProcessTimeout(Exception):
    """A call took longer than it may."""


class SandboxProcess:
    """One submission's process: requests in, replies out, each with a limit."""

    def __init__(self, channel: socket.socket, leash: socket.socket, call_limit: float) -> None:
        self._channel, self.leash, self.limit = channel, leash, call_limit
        self._ended = False  # the process has closed its end
        self._channel.setblocking(False)
        self.leash.settimeout(60)  # s; the monitor answers within a few hundredths where the machine is not busy
        self._received = bytearray()
        self._budget, self._room = ItemBudget(), LARGEST_REPLY  # for the replies to the request before us
        self._waited = 0.0  # s, in earlier calls: no less than the CPU time they took
        self.lasted = 0.0  # s on the wall's clock, of all calls and of reading what they sent
        self.read = 0.0  # s of our own, in reading what it sent
        self._cpu = 0.0  # s, at the end
        # when we last asked for the CPU time to see whether it grows, and what it was
        self._looked_at = (0.0, 0.0)
        self._stood_still = 0.0  # s, in which this process was not run: suspended, or the whole machine was
        self.monitored = True  # until the monitor does not answer
        self.killed_from_outside = False  # at the end, by its monitor's word
        self._last_words: list[str] = []  # of the monitor, once the process has ended

    def send(self, request: Any) -> None:
        """Send a request, of bytes or to be packed, or raise ProcessLost or ProcessTimeout."""
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
        """Return the next reply in its form, or raise ProcessLost or ProcessTimeout.

        What it costs us to read it is counted as the submission's own time: a class waits for no forged reply.
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

        ProcessLost if its monitor has gone.
        """
        try:
            self._order(b"c")
            return float(self._heard()[0])
        except (OSError, IndexError):
            raise ProcessLost from None

    def end(self) -> float:
        """Kill the process; the CPU seconds it has used. A monitor that does not answer has died with its zygote."""
        try:
            self._order(b"e" if self._ended else b"k")
            self._hear_last_words()
            self._cpu, self.killed_from_outside = float(self._last_words[0]), self._last_words[1] == "1"
        except OSError:
            self.monitored, self._cpu = False, max(self._cpu, self._waited)
            self.leash.close()
        self._channel.close()
        return self._cpu

    def drop(self) -> None:
        """Let the monitor kill the process, without waiting for it."""
        self._order(b"k")
        self._channel.close()

    def let_go(self) -> None:
        """Close our ends: the process ends if nobody else holds them."""
        self.leash.close()
        self._channel.close()

    def has_ended(self) -> bool:
        """Whether it was dropped, and its monitor has seen it end; OSError if the monitor has gone."""
        if self._channel.fileno() >= 0:
            return False
        if self.monitored and not self._last_words:
            said = select.poll()
            said.register(self.leash, select.POLLIN)
            if not said.poll(0):
                return False
        self._hear_last_words()
        return True

    def _hear_last_words(self) -> None:
        while not self._last_words:
            self._heard()  # the answer to an earlier question

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
            chunk = self._channel.recv(PIECE)
        except OSError:
            chunk = b""
        if not chunk:
            self._ended = True
            raise ProcessLost
        self._received += chunk

    def _message(self) -> bytes | None:
        """Return the first whole message received, taken out of the buffer."""
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
        """Return whether a call has had its CPU time, or uses none.

        On a busy machine its time on the wall says little.
        """
        try:
            cpu = self.seconds()
        except ProcessLost:
            return True
        now = self._clock()
        since, cpu_then = max(self._looked_at, (started, 0.0))
        idle = cpu - cpu_then < IDLE_SHARE * self.limit
        if now - since >= self.limit:
            self._looked_at = now, cpu
        else:
            idle = False
        return idle or cpu - self._waited >= self.limit or now - started > PATIENCE * self.limit

    def _order(self, order: bytes) -> None:
        """Send the monitor an order. It may have gone with its process, and its last words are still to be read."""
        with suppress(ConnectionError):
            self.leash.sendall(order)

    def _heard(self) -> list[str]:
        """Return what the monitor says next; after its last words, these."""
        line = b""
        while not self._last_words and not line.endswith(b"\n"):
            chunk = self.leash.recv(1)
            if not chunk:
                raise OSError("the monitor has gone")
            line += chunk
        words = line.decode().split()
        self._last_words = self._last_words or (words if len(words) > 1 else [])
        return self._last_words or words
