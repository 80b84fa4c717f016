"""A submission that runs in this process, whose cases are judged one by one.

A comparison that fails is noted, and the check goes on. A reply that cannot be compared is noted and replaced by the
solution's. Nothing here is a sandbox: it is for mutants and mistakes of ours.
"""

import contextlib
import importlib
import signal
import sys
import time
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from functools import cache, partial
from pathlib import Path
from types import ModuleType
from typing import Any, NamedTuple

import numpy as np

from tam570.values import Json
from tam570_grader.checks import assignments
from tam570_grader.checks.assignments import LoadedAssignment
from tam570_grader.checks.case import Call, Case
from tam570_grader.checks.check import Check
from tam570_grader.checks.expect import CheckContext, Failed, check_context
from tam570_grader.checks.returns import Array, FreeBodyDiagram, Group, result
from tam570_grader.grading.run_checks import generator
from tam570_grader.protocol.answer import answers
from tam570_grader.protocol.wire import packed, unpacked
from tam570_grader.sandbox.function import SandboxFunction
from tam570_grader.sandbox.replies import checked

SEED = 570
SLOWEST = 2.0  # s of processor time of a call
TOO_SLOW = {"error": {"kinds": ["SlowCall"], "text": "", "line": 0}}

Reply = Json


class Key(NamedTuple):
    """A hidden case, the same for every seed: the nth of its label that a check gives to a function."""

    check: str
    function: str
    label: str
    nth: int


class SlowCall(Exception):
    """A call takes longer than any right one."""


class Replies:
    """What a module answers, each call computed once; functions out of reach of its slip answer as the solution."""

    def __init__(self, module: ModuleType, solution: "Replies | None" = None, reach: frozenset[str] = frozenset()):
        self._module, self._solution, self._reach = module, solution, reach
        self._replies: dict[tuple[str, bytes, str, str], Reply] = {}
        self.seconds: dict[tuple[str, bytes], float] = {}

    def reply(self, name: str, case: Case, mode: str, fields: Json) -> Reply:
        if self._solution and name not in self._reach:
            return self._solution.reply(name, case, mode, fields)
        key = name, case.packed, mode, repr(fields)
        if key not in self._replies:
            began = time.process_time()
            self._replies[key] = _answered(self._module, name, case, mode, fields)
            self.seconds[name, case.packed] = time.process_time() - began
        return self._replies[key]


def _answered(module: ModuleType, name: str, case: Case, mode: str, fields: Json) -> Reply:
    request = {"function": name, "mode": mode, "refused": (), "calls": [unpacked(case.packed)], **fields}
    try:
        with _clock(), np.errstate(all="ignore"):
            (reply,) = answers(module, request)
    except SlowCall:
        return TOO_SLOW
    return checked(unpacked(packed({"replies": [reply]})), mode)[0]


@contextlib.contextmanager
def _clock() -> Iterator[None]:

    def end(*_: object) -> None:
        raise SlowCall

    before = signal.signal(signal.SIGPROF, end)
    signal.setitimer(signal.ITIMER_PROF, SLOWEST)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, before)


class LocalStudent:
    """A submission as a check sees it."""

    def __init__(self, assignment: LoadedAssignment, check: Check, solution: Replies, replies: Replies) -> None:
        self._assignment, self._check, self._solution, self._replies = assignment, check, solution, replies
        self.text = ""
        self.failed: set[Key] = set()
        self.replaced: set[Key] = set()  # cases whose replies are the solution's
        self.start()

    def __getattr__(self, name: str) -> SandboxFunction:
        if name not in self._assignment.results:
            raise AttributeError(name)
        return SandboxFunction(self, name, self._assignment.results[name])

    def start(self) -> None:
        """Begin the check, or begin it again."""
        self.calls: list[Call] = []
        self.worked: set[str] = set()
        self.cases: dict[Key, Case] = {}
        self.functions: set[str] = set()  # that were called
        self._keys: dict[tuple[str, int], Key] = {}
        self._count: Counter[tuple[str, str]] = Counter()

    def key(self, function: str, case: Case | None) -> Key:
        """Return the key of a case that this check asks for; of no case, the check's own."""
        if case is None:
            return Key(self._check.name, "", "", 1)
        if (function, id(case)) not in self._keys:
            self._count[function, case.label] += 1
            key = Key(self._check.name, function, case.label, self._count[function, case.label])
            self._keys[function, id(case)], self.cases[key] = key, case
        return self._keys[function, id(case)]

    def takes(self, name: str) -> str:
        return ""

    def aside(self, retried: str = "") -> contextlib.AbstractContextManager[None]:
        return contextlib.nullcontext()

    def replies(self, name: str, calls: Sequence[Case], mode: str = "value", **more: Any) -> list[Reply]:
        self.functions.add(name)
        return [self._reply(name, case, mode, more) for case in calls]

    def _reply(self, name: str, case: Case, mode: str, fields: Json) -> Reply:
        expected = partial(self._solution.reply, name, case, mode, fields)
        if mode == "formula":  # one call for all points
            key = Key(self._check.name, name, "", 1)
        elif (key := self.key(name, case)) in self.replaced:
            return expected()
        reply = self._replies.reply(name, case, mode, fields)
        if self._is_faulty(name, case, mode, reply, expected if fields.get("every") else None):
            self.failed.add(key)
            return expected()
        return reply

    def _is_faulty(self, name: str, case: Case, mode: str, reply: Reply, expected: Callable[[], Reply] | None) -> bool:
        """Return whether a reply fails the check whatever its numbers are."""
        if expected:  # where ValueError may be right
            return ("error" in reply) != ("error" in expected())
        returns = self._assignment.results[name]
        if "error" in reply or mode != "value" or not isinstance(returns, Array | Group | FreeBodyDiagram):
            return "error" in reply
        try:
            result(returns, reply["value"], name, case)
        except Failed:
            return True
        return bool(reply["changed"])


def failed_cases(student: LocalStudent, check: Check, seed: int, slug: str) -> set[Key]:
    """Return the cases of a check that a submission fails; the check is run again without those that end it."""
    while True:
        student.start()
        context = CheckContext()
        try:
            with check_context() as context, np.errstate(all="ignore"):
                context.recorder = partial(_record, student, context)
                check.run(student, generator(seed, slug, check))
        except Exception:  # Failed, or what follows where a comparison that failed did not end the check
            key = student.key(context.function, context.case)
            student.failed.add(key)
            if key not in student.replaced:
                student.replaced.add(key)
                continue
        return student.failed


def _record(student: LocalStudent, context: CheckContext, error: float) -> None:
    key = student.key(context.function, context.case)
    if not error <= 1:
        student.failed.add(key)


def module_of(text: str) -> ModuleType:
    """Return a module that may raise at import: then none of its functions is there."""
    module = sys.modules["_audited"] = ModuleType("_audited")  # a dataclass looks for its module there
    try:
        exec(compile(text, "<submission>", "exec"), vars(module))
    except Exception:
        return ModuleType("_raises")
    return module


@cache
def solution_replies(course: Path, slug: str, seed: int) -> Replies:
    """Return the solution's replies, for all that one seed asks."""
    return Replies(module_of(assignments.assignment(course, slug).solution))


def students_of_checks(course: Path, slug: str) -> dict[str, LocalStudent]:
    """Return the solution as each check has seen it, with the cases that it asked for."""
    assignment, solution = assignments.assignment(course, slug), solution_replies(course, slug, SEED)
    students = dict[str, LocalStudent]()
    for module in assignment.needs:  # as in the sandbox, no call waits for it
        importlib.import_module(module)
    for check in assignment.checks:
        student = students[check.name] = LocalStudent(assignment, check, solution, solution)
        failed = failed_cases(student, check, SEED, slug)
        assert not failed, failed
    return students


def calls_of_checks(course: Path, slug: str) -> tuple[dict[str, set[str]], float]:
    """Return the functions that each check calls, and the longest call in s, by running them on the solution."""
    calls = {check: student.functions for check, student in students_of_checks(course, slug).items()}
    return calls, max(solution_replies(course, slug, SEED).seconds.values())
