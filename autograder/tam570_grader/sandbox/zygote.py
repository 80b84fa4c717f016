"""The supervisor's connection to a zygote: start it, try it out, and open a process for each submission."""

import functools
import itertools
import json
import math
import os
import select
import socket
from collections.abc import Sequence
from contextlib import ExitStack, suppress
from dataclasses import dataclass
from pathlib import Path

from tam570.values import Json
from tam570_grader.errors import Over
from tam570_grader.protocol.wire import LENGTH
from tam570_grader.sandbox.launch import isolation, launch
from tam570_grader.sandbox.process import ProcessLost, ProcessTimeout, SandboxProcess
from tam570_grader.sandbox.replies import checked, imported

FILE_SIZE = 2**25  # bytes that a submission may write into its scratch folder
LOWEST_USER, USERS = 20_000, 40_000  # lowest and number of user ids that nobody has and most containers map
CANARY = b"""
def right(x):
    return [x, 2 * x]

def endless():
    while True:
        pass
"""
REQUEST = {"mode": "value", "refused": []}
STOPPED_AFTER = 0.002  # s, time limit of the endless call

_serial = itertools.count()


@dataclass(frozen=True)
class ResourceLimits:
    """What a submission may use."""

    memory: int = 2**30  # bytes
    cpu: float = 60.0  # s of CPU time for the submission
    call: float = 10.0  # s of CPU time for one call
    processes: int = 1


class ZygoteLost(Over):
    """The zygote has died, or the submission was killed from outside; the submission is not at fault."""


class NotConfined(ZygoteLost):
    """The zygote runs, but cannot confine or grade a submission as required; the message says why."""


class Zygote:
    """A warm process, in bubblewrap if that works, of which a fork runs each submission.

    Supervisors that are forked from its owner share it: messages with file descriptors are not merged on its socket.
    """

    def __init__(self, preload: Sequence[str], limits: ResourceLimits, hidden: Sequence[Path] = ()) -> None:
        self.limits, self._serial, self._launched = limits, next(_serial), launch(hidden)
        self._control = self._launched.control
        of_all: Json = {"file_size": FILE_SIZE, "processes": limits.processes}  # the same for all processes
        of_all |= {"memory": limits.memory, "namespaces": isolation() == "bubblewrap"}
        settings = json.dumps({"limits": of_all, "preload": list(preload)}).encode()
        with suppress(OSError):  # if it has ended, `try_out` raises
            self._control.sendall(LENGTH.pack(len(settings)) + settings)
        self._ready = False
        self._canary: SandboxProcess | None = None
        self._holder, self._processes = os.getpid(), list[SandboxProcess]()  # the last process of each monitor
        self._order: Json = {}  # the last order
        self._spare: SandboxProcess | None = None  # a process for the next equal order
        with suppress(ZygoteLost):
            self._canary = self._start_canary()

    @property
    def user(self) -> int | None:
        """The user id of submissions under root, different for each supervisor and zygote; None if they keep ours."""
        if os.geteuid() or not _maps_users():
            return None
        return LOWEST_USER + (16 * os.getpid() + self._serial) % USERS

    def process(self, cpu: float, hidden: Sequence[str] = (), states: Sequence[int] = ()) -> SandboxProcess:
        """Return a new process with nothing loaded, with `cpu` seconds of CPU time, that cannot see hidden modules.

        After two equal orders, a spare process for the next one is started, and confined while this one works.

        states : see `Assignment`
        """
        if self._holder != os.getpid():  # the monitors belong to the supervisor from which this one was forked
            self._let_go()
        self.try_out()
        order: Json = {"cpu": max(1, math.ceil(cpu)), "hidden": list(hidden), "states": list(states)}
        is_repeated = order == self._order
        if self._spare and not is_repeated:
            self._spare.drop()
            self._spare = None
        process = self._spare or self._opened(order)
        self._order, self._spare = order, None
        self._must_be_confined(process)
        # only if submissions cannot see the spare, and their limit, which counts it, allows no further process anyway
        if is_repeated and isolation() == "bubblewrap" and self.limits.processes == 1:
            self._spare = self._opened(order)
        return process

    def compile_steps(self, states: Sequence[int]) -> None:
        """Let the zygote compile integration steps of these numbers of components for later monitors; do not wait."""
        with suppress(OSError):  # if it has ended, `try_out` raises
            self._control.sendall(bytes(states))

    def _opened(self, order: Json) -> SandboxProcess:
        """Return a process for an order, which may not be confined yet."""
        channel, process_end = socket.socketpair()
        order = {**order, "user": self.user}
        with process_end, ExitStack() as opened:
            opened.enter_context(channel)
            try:
                leash = opened.enter_context(self._free_leash())
                socket.send_fds(leash, [json.dumps(order).encode()], [process_end.fileno()])
            except OSError:
                raise ZygoteLost("the zygote died") from None
            opened.pop_all()
        process = SandboxProcess(channel, leash, self.limits.call)
        self._processes.append(process)
        return process

    def _free_leash(self) -> socket.socket:
        """Return the leash of a monitor whose process has ended, or of a new monitor."""
        for process in list(self._processes):
            try:
                if process.has_ended():
                    self._processes.remove(process)
                    return process.leash
            except OSError:  # its monitor has ended
                self._processes.remove(process)
                process.leash.close()
        leash, monitor_end = socket.socketpair()
        with monitor_end, ExitStack() as opened:
            opened.enter_context(leash)
            socket.send_fds(self._control, [b"g"], [monitor_end.fileno()])
            opened.pop_all()
        return leash

    def _let_go(self) -> None:
        for process in self._processes:
            process.let_go()
        self._holder, self._processes, self._spare, self._canary = os.getpid(), [], None, None

    def _must_be_confined(self, process: SandboxProcess) -> None:
        """Wait until a process, which has seen no submission yet, is confined; else raise ZygoteLost or NotConfined."""
        try:
            reply = process.receive(lambda reply: reply)
        except (ProcessLost, ProcessTimeout):
            process.end()
            raise ZygoteLost(f"a process ended before it was confined: {self._launched.errors()}") from None
        if reply != {"confined": True}:
            process.end()
            raise NotConfined(reply["confined"])

    def _start_canary(self) -> SandboxProcess:
        """Return a process to which the canary and its right call have been sent; do not wait: the zygote may start.

        The sockets buffer the order to open the process, behind the settings, and the requests.
        """
        process = self._opened({"cpu": math.ceil(self.limits.cpu), "hidden": [], "states": []})
        load = {"source": CANARY, "notebook": False, "name": "canary", "functions": ["right", "endless"]}
        with suppress(ProcessLost, ProcessTimeout):  # `try_out` will notice
            process.send({**load, "uncallable": [], "forbidden": []})
            process.send({**REQUEST, "function": "right", "calls": [[[1.5], {}]]})
        return process

    def try_out(self) -> None:
        """Grade a canary before any submission: a right call must work, an endless one be late; else NotConfined."""
        if self._ready:
            return
        self._await_ready()
        process, self._canary = self._canary or self._start_canary(), None
        self._must_be_confined(process)
        try:
            for _ in range(2):
                process.receive(imported)
            (reply,) = process.receive(lambda message: checked(message, "value"))
            as_it_must = reply["value"].tolist() == [1.5, 3.0]
        except (ProcessLost, ProcessTimeout, LookupError, AttributeError):
            as_it_must = False
        stopped = as_it_must and _is_stopped(process)
        process.end()
        if not process.monitored or process.killed_from_outside:
            raise ZygoteLost("the zygote was killed while it was tried out")
        if not as_it_must:
            raise NotConfined("a right submission does not get through")
        if not stopped:
            raise NotConfined("a call that does not end is not stopped")
        self._ready = True

    def must_live(self) -> None:
        """Raise ZygoteLost if the zygote is ending or has ended."""
        hung_up = select.poll()
        hung_up.register(self._control, 0)
        if hung_up.poll(1000):
            raise ZygoteLost("the zygote died")

    def close(self) -> None:
        """Close the sockets; if this process started the zygote, kill it and everything in it."""
        self._let_go()
        self._launched.close()

    def _await_ready(self) -> None:
        try:
            said = self._control.recv(5, socket.MSG_PEEK)  # other supervisors need the message, too
        except OSError:
            said = b""
        if said != b"ready":
            self._launched.wait()
            raise ZygoteLost(f"the sandbox did not start: {self._launched.errors()}")


def _is_stopped(process: SandboxProcess) -> bool:
    """Return whether an endless call raises ProcessTimeout."""
    process.limit = STOPPED_AFTER
    try:
        process.send({**REQUEST, "function": "endless", "calls": [[[], {}]]})
        process.receive(lambda reply: reply)
    except ProcessTimeout:
        return True
    except ProcessLost:
        return False
    return False


@functools.cache
def _maps_users() -> bool:
    """Return whether root can change to the user ids of submissions.

    In a rootless container, these ids may not exist.
    """
    for path in filter(Path.exists, (Path("/proc/self/uid_map"), Path("/proc/self/gid_map"))):
        ranges = [(int(first), int(count)) for first, _, count in map(str.split, path.read_text().splitlines())]
        last = LOWEST_USER + USERS
        if not any(first <= LOWEST_USER and first + count >= last for first, count in ranges):
            return False
    return True
