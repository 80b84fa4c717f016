"""The student as a check sees it: functions that are called in the sandbox."""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from typing import Any

from tam570.values import Function, Json
from tam570_grader.checks.assignments import LoadedAssignment
from tam570_grader.checks.case import Call, Case
from tam570_grader.checks.expect import Failed, NotWritten, get_context
from tam570_grader.errors import Over, printable
from tam570_grader.protocol.wire import request
from tam570_grader.sandbox.function import SandboxFunction
from tam570_grader.sandbox.imports import NotLoaded, not_compiled, not_imported, skipped_cells
from tam570_grader.sandbox.pool import ONLY, Attempt
from tam570_grader.sandbox.process import PATIENCE, ProcessLost, ProcessTimeout, SandboxProcess
from tam570_grader.sandbox.replies import checked, imported
from tam570_grader.sandbox.zygote import Zygote, ZygoteLost

SLOW, MOST_SLOW = 0.5, 4  # s, wall time of a request whose replies are kept for asides, and number of these


@dataclass(frozen=True)
class Source:
    """The text of a submitted module or notebook; `remark` names other files that were handed in and not graded."""

    text: bytes
    notebook: bool = False
    remark: str = ""


class BudgetSpent(Over):
    """The submission has used up its CPU time or wall time; the message says which."""

    status = "timeout"


class Student:
    """A submission in the sandbox; `student.f` is the function f of the contract."""

    def __init__(self, source: Source, assignment: LoadedAssignment, zygote: Zygote, attempt: Attempt = ONLY) -> None:
        self._forgiving, self._informed = attempt.forgiving, attempt.is_retry
        self.calls: list[Call] = []  # calls of the check that is running
        self.may_change = False  # whether the functions may change the arrays that they are given
        self.skipped: list[str] = []  # sentences on skipped notebook cells
        self._source, self.assignment, self._zygote = source, assignment, zygote
        self._processes: dict[tuple[str, ...], SandboxProcess] = {}  # by modules that are off limits in it
        self._defined: set[str] = set()
        self.broken: dict[str, Json] = {}  # functions that hung or crashed, and how
        self._given_up: set[str] = set()  # functions that did so in a block of `aside`
        self.worked: set[str] = set()  # functions with a valid result, so that failures depend on the input
        self.uses: dict[tuple[str, str, bytes], bool] = {}  # whether a call of a function depends on a helper
        self._asides = 0  # open blocks of `aside`
        self._slow: dict[bytes, list[Json]] = {}  # replies to the last slow requests of checks, by request
        self._cpu, self._lasted = 0.0, 0.0  # s, CPU time and wall time of the processes that have ended

    def __getattr__(self, name: str) -> "Function":
        if name not in self.assignment.returns:
            raise AttributeError(f"the contract of {self.assignment.slug} has no function {name}")
        return SandboxFunction(self, name, self.assignment.returns[name])

    @contextmanager
    def aside(self, retried: str = "") -> Iterator[None]:
        """Open a block for calls that are not graded: `calls`, `broken` and the context are restored at its end.

        Calls in it raise Failed once the submission has used half of its CPU time.

        retried : a function to call although it hung or crashed before, unless it did so in such a block
        """
        running = get_context()
        calls, broken, function, case = self.calls, self.broken, running.function, running.case
        tried = {name: why for name, why in broken.items() if name != retried or name in self._given_up}
        self.calls, self.broken = list(calls), dict(tried)
        self._asides += 1
        try:
            yield
        finally:
            self._asides -= 1
            self._given_up |= self.broken.keys() - tried.keys()
            self.calls, self.broken, running.function, running.case = calls, broken, function, case

    @contextmanager
    def on_copies(self) -> Iterator[None]:
        """Open a block in which the functions may change the arrays that they are given."""
        self.may_change = True
        try:
            yield
        finally:
            self.may_change = False

    @contextmanager
    def afresh(self) -> Iterator[None]:
        """Open a block like `aside`, with new processes, in which nothing is left of earlier calls."""
        earlier, slow = self._processes, self._slow
        self._processes, self._slow = {("", *key): process for key, process in earlier.items()}, {}
        try:
            with self.aside():
                yield
        finally:
            for key in self._processes.keys() - {("", *key) for key in earlier}:
                self._end_process(self._processes.pop(key))
            self._processes, self._slow = earlier, slow

    def load(self) -> None:
        """Import the submission; raise NotLoaded if that fails."""
        self._process(())

    def seconds(self) -> float:
        """Return the CPU seconds that the submission has used."""
        return self._cpu + sum(process.seconds() for process in self._processes.values())

    def describe_missing(self, name: str) -> str:
        """Return a sentence on a function that is missing or still the stub."""
        return f"{name} is not written yet." if name in self._defined else f"Your file has no function {name}."

    def leave(self) -> None:
        """End the submission's processes."""
        for process in self._processes.values():
            process.drop()
        self._processes.clear()

    @property
    def text(self) -> str:
        """The submitted text, with undecodable bytes replaced."""
        return self._source.text.decode("utf-8", "replace")

    def replies(self, name: str, calls: Sequence[Case], mode: str = "value", **more: Any) -> list[Json]:
        """Return a reply for each call up to the first error; raise Failed if the function hangs or ends its process.

        more : fields of the request; with every=True, also make the calls after an error
        """
        if name in self.broken:
            raise Failed(**self.broken[name])
        if self._asides and self.seconds() > self._zygote.limits.cpu / 2:
            raise Failed(f"{name} takes too long to be called once more")
        banned, results = self.assignment.forbidden.get(name, ()), self.assignment.returns
        refused = [name for name in banned if name in results]  # functions of the file; the others are modules
        uncallable = tuple(name for name in banned if name not in results)
        process = self._process(uncallable)
        if name not in self._defined:
            raise NotWritten(name)
        replies: list[Json] = []
        message = request([case.packed for case in calls], function=name, mode=mode, refused=refused, **more)
        if self._asides and message in self._slow:
            return self._slow[message]
        before = process.lasted
        try:
            process.send(message)
            while len(replies) < len(calls) and (more.get("every") or not (replies and "error" in replies[-1])):
                replies += process.receive(partial(checked, mode=mode, most=len(calls) - len(replies)))
                self._must_end()
        except ProcessTimeout:
            slow = f"{name} did not return within {self._zygote.limits.call:g} s"
            self._end(uncallable, name, slow, calls[len(replies)])
        except ProcessLost:
            how = "it exited, crashed or used too much memory"
            self._end(uncallable, name, f"{name} ended its process: {how}", calls[len(replies)])
        if self._asides <= 1 and process.lasted - before > SLOW:
            self._slow = dict([*self._slow.items(), (message, replies)][-MOST_SLOW:])
        return replies

    def _must_end(self) -> None:
        """Raise BudgetSpent if reading its replies took the submission's CPU time, or its wall time is too long.

        The sandbox process itself limits its CPU time.
        """
        read = self._cpu + sum(process.read for process in self._processes.values())
        if read > (most := self._zygote.limits.cpu):
            raise BudgetSpent(f"the submission has used its {most:g} s of processor time")
        lasted = self._lasted + sum(process.lasted for process in self._processes.values())
        if lasted > (most := PATIENCE * self._zygote.limits.cpu):
            raise BudgetSpent(f"the submission has taken {most:g} s, and used little processor time")

    def _end(self, uncallable: tuple[str, ...], name: str, message: str, call: Case) -> None:
        """End a process; raise Failed, now and at each later call of the function, or BudgetSpent if time is up."""
        self._end_process(self._processes.pop(uncallable))
        label = call.label if name in self.worked else ""
        why: Json = {"message": message, "label": label, "at": call, "function": name}
        self.broken[name] = why
        self._must_end()
        if self._cpu >= (most := self._zygote.limits.cpu) - 0.5:
            raise BudgetSpent(f"the submission has used its {most:g} s of processor time")
        raise Failed(**why)

    def _end_process(self, process: SandboxProcess) -> None:
        """End a process and add its times; raise ZygoteLost if it died with its zygote, or was killed from outside."""
        self._cpu += process.end() + process.read
        self._lasted += process.lasted
        if not process.monitored:
            self._zygote.must_live()
        if self._forgiving and (process.killed_from_outside or not process.monitored):
            raise ZygoteLost("the submission was killed by another process")

    def _process(self, uncallable: tuple[str, ...]) -> SandboxProcess:
        """Return the process, with the submission loaded, for functions in which these modules are off limits."""
        if uncallable not in self._processes:
            hidden = [*self.assignment.forbidden.get("*", ()), *uncallable]
            process = self._zygote.process(self._zygote.limits.cpu - self._cpu, hidden, self.assignment.states)
            try:
                self._load(process, uncallable)
            except NotLoaded:
                self._end_process(process)
                raise
            self._processes[uncallable] = process
            self._must_end()
        return self._processes[uncallable]

    def _load(self, process: SandboxProcess, uncallable: tuple[str, ...]) -> None:
        try:
            process.send(
                {
                    "source": self._source.text,
                    "notebook": self._source.notebook,
                    "name": self.assignment.slug,
                    "functions": list(self.assignment.returns),
                    "uncallable": list(uncallable),
                    "forbidden": list(self.assignment.forbidden.get("*", ())),
                }
            )
            compiled = process.receive(imported)
            reply = compiled if "error" in compiled else process.receive(imported)
        except ProcessTimeout:
            slow = "Your file takes too long to import: does it run a simulation by itself?"
            raise NotLoaded("timeout", slow) from None
        except ProcessLost:
            how = "it exited, crashed or used too much memory"
            raise NotLoaded("crashed", f"Your file ended its process at import: {how}") from None
        text, informed = self._source.text, self._informed
        if "error" in compiled:
            raise not_compiled(compiled)
        if "error" in reply:
            raise not_imported(reply, text, self.assignment, informed)
        self._defined = set(reply["names"])
        if not informed:
            self.skipped = [*map(printable, compiled["names"]), *skipped_cells(reply["skipped"], text)]
        self._informed = True
