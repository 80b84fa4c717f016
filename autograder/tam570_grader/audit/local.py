"""Run submissions in this process, and find out which cases of a check fail.

A failed comparison is recorded, and the check continues. A reply that cannot be compared is recorded and replaced by
the solution's. This is no sandbox: use it only for our own mutants and mistakes.
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
from typing import Any, NamedTuple, cast

import numpy as np

from tam570.values import Json
from tam570_grader.checks import assignments
from tam570_grader.checks.assignments import LoadedAssignment
from tam570_grader.checks.case import Case
from tam570_grader.checks.check import Check
from tam570_grader.checks.expect import Failed, check_context, get_context
from tam570_grader.checks.returns import Array, FreeBodyDiagram, Group, result
from tam570_grader.grading.seeds import generator
from tam570_grader.protocol.answer import answers
from tam570_grader.protocol.wire import packed, unpacked
from tam570_grader.sandbox.replies import checked
from tam570_grader.sandbox.student import Source, Student
from tam570_grader.sandbox.zygote import Zygote

SEED = 570
SLOWEST = 2.0  # s of CPU time, limit of a call
TOO_SLOW = {"error": {"kinds": ["SlowCall"], "text": "", "line": 0}}

Reply = Json


class Key(NamedTuple):
    """Key of a hidden case, the same for every seed: the nth case with its label that a check gives to a function."""

    check: str
    function: str
    label: str
    nth: int


class SlowCall(Exception):
    """A call exceeds SLOWEST."""


class Replies:
    """Cached replies of a module; functions outside `reach`, which its slip cannot affect, reply as the solution."""

    def __init__(self, module: ModuleType, solution: "Replies | None" = None, reach: frozenset[str] = frozenset()):
        self._module, self._solution, self._reach = module, solution, reach
        self._replies: dict[tuple[str, bytes, str, str], Reply] = {}
        self.seconds: dict[tuple[str, bytes], float] = {}

    def reply(self, name: str, case: Case, mode: str, fields: Json) -> Reply:
        if self._solution and name not in self._reach:
            return self._solution.reply(name, case, mode, fields)
        key = name, case.packed, mode, repr(fields)
        if key not in self._replies:
            request = {"function": name, "mode": mode, "refused": (), "calls": [unpacked(case.packed)], **fields}
            began = time.process_time()
            try:
                with _clock(), np.errstate(all="ignore"):
                    (reply,) = answers(self._module, request)
                self._replies[key] = checked(unpacked(packed({"replies": [reply]})), mode)[0]
            except SlowCall:
                self._replies[key] = TOO_SLOW
            self.seconds[name, case.packed] = time.process_time() - began
        return self._replies[key]


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


class LocalStudent(Student):
    """A submission as a check sees it, whose functions are called in this process."""

    may_change = False

    def __init__(self, assignment: LoadedAssignment, check: Check, solution: Replies, replies: Replies) -> None:
        super().__init__(Source(b""), assignment, cast(Zygote, None))
        self._check, self._solution, self._replies = check, solution, replies
        self.failed: set[Key] = set()
        self.replaced: set[Key] = set()  # cases whose replies are replaced by the solution's
        self.start()

    def start(self) -> None:
        """Reset the state for another run of the check; keep `failed` and `replaced`."""
        self.calls, self.worked = [], set()
        self.cases: dict[Key, Case] = {}
        self.functions: set[str] = set()  # functions that were called
        self._keys: dict[tuple[str, int], Key] = {}
        self._count: Counter[tuple[str, str]] = Counter()

    def key(self, function: str, case: Case | None) -> Key:
        """Return the key of a case; for None, a key of the check itself."""
        if case is None:
            return Key(self._check.name, "", "", 1)
        if (function, id(case)) not in self._keys:
            self._count[function, case.label] += 1
            key = Key(self._check.name, function, case.label, self._count[function, case.label])
            self._keys[function, id(case)], self.cases[key] = key, case
        return self._keys[function, id(case)]

    def record(self, error: float) -> None:
        """Count the case of the running check as failed if an error, divided by its limit, is above 1."""
        key = self.key(get_context().function, get_context().case)
        if not error <= 1:
            self.failed.add(key)

    def replies(self, name: str, calls: Sequence[Case], mode: str = "value", **more: Any) -> list[Reply]:
        self.functions.add(name)
        return [self._reply(name, case, mode, more) for case in calls]

    def _reply(self, name: str, case: Case, mode: str, fields: Json) -> Reply:
        expected = partial(self._solution.reply, name, case, mode, fields)
        if mode == "formula":  # one case for all points
            key = Key(self._check.name, name, "", 1)
        elif (key := self.key(name, case)) in self.replaced:
            return expected()
        reply = self._replies.reply(name, case, mode, fields)
        if self._is_faulty(name, case, mode, reply, expected if fields.get("every") else None):
            self.failed.add(key)
            return expected()
        return reply

    def _is_faulty(self, name: str, case: Case, mode: str, reply: Reply, expected: Callable[[], Reply] | None) -> bool:
        """Return whether a reply fails the check independently of its numbers."""
        if expected:  # exceptions may be right
            return ("error" in reply) != ("error" in expected())
        returns = self.assignment.returns[name]
        if "error" in reply or mode != "value" or not isinstance(returns, Array | Group | FreeBodyDiagram):
            return "error" in reply
        try:
            result(returns, reply["value"], name, case)
        except Failed:
            return True
        return bool(reply["changed"])


def failed_cases(student: LocalStudent, check: Check, seed: int, slug: str) -> set[Key]:
    """Return the cases of a check that a submission fails; repeat the check, with replies replaced, until it ends."""
    while True:
        student.start()
        try:
            with check_context(recorder=student.record) as context, np.errstate(all="ignore"):
                check.run(student, generator(seed, slug, check))
        except Exception:  # Failed, or any exception after a failed comparison that did not end the check
            key = student.key(context.function, context.case)
            student.failed.add(key)
            if key not in student.replaced:
                student.replaced.add(key)
                continue
        return student.failed


def module_of(text: str) -> ModuleType:
    """Return the module with this source; an empty one if it raises at import."""
    module = sys.modules["_audited"] = ModuleType("_audited")  # a dataclass looks for its module there
    try:
        exec(compile(text, "<submission>", "exec"), vars(module))
    except Exception:
        return ModuleType("_raises")
    return module


@cache
def solution_replies(course: Path, slug: str, seed: int) -> Replies:
    """Return the solution's replies, cached for one seed."""
    return Replies(module_of(assignments.assignment(course, slug).solution))


def students_of_checks(course: Path, slug: str) -> dict[str, LocalStudent]:
    """Return by check the solution as a student on which the check has run, with all its cases."""
    assignment, solution = assignments.assignment(course, slug), solution_replies(course, slug, SEED)
    students = dict[str, LocalStudent]()
    for module in assignment.needs:  # as in the sandbox, before the first call
        importlib.import_module(module)
    for check in assignment.checks:
        student = students[check.name] = LocalStudent(assignment, check, solution, solution)
        failed = failed_cases(student, check, SEED, slug)
        assert not failed, failed
    return students


def calls_of_checks(course: Path, slug: str) -> tuple[dict[str, set[str]], float]:
    """Run the checks on the solution; return the functions that each calls, and the longest time of a call in s."""
    calls = {check: student.functions for check, student in students_of_checks(course, slug).items()}
    return calls, max(solution_replies(course, slug, SEED).seconds.values())
