"""The student as a check sees it: functions to call, each call made in the sandbox, each result what was promised."""

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from tam570_grader.errors import Over, printable
from tam570_grader.sandbox.cell import PATIENCE, Cell, CellLost, CellTimeout
from tam570_grader.sandbox.imports import NotLoaded, not_compiled, not_imported, python_class, skipped_cells, started
from tam570_grader.sandbox.inside.wire import request
from tam570_grader.sandbox.replies import checked, error_of, imported, strings
from tam570_grader.sandbox.warm import ONLY, Attempt
from tam570_grader.sandbox.worker import Worker, WorkerLost
from tam570_grader.writing.assignments import Assignment
from tam570_grader.writing.check import Given, given
from tam570_grader.writing.drawings import readable
from tam570_grader.writing.expect import Failed, NotWritten, current
from tam570_grader.writing.returns import Drawing, Formula, result

__all__ = ["BudgetSpent", "Call", "NotLoaded", "Source", "Student"]

REAL = 1e-12  # of a value: complex exponentials that make it real leave 1e-25 of imaginary part
ROUNDING = 1e-25  # where they cancel to zero
STRANGER = r"[A-Za-z]{1,12}(_?[A-Za-z0-9]{1,3})?(\(t\))?"  # a symbol's name, theta_1, or a function of time, theta(t)


@dataclass(frozen=True)
class Source:
    """What a student handed in."""

    text: bytes
    notebook: bool = False


@dataclass(frozen=True)
class Call:
    """A call that a check made and the result that came back."""

    name: str
    given: Given
    result: Any  # None where the call raised, or returned what was not promised


class BudgetSpent(Over):
    """The submission has had all of its time; the message says which."""

    status = "timeout"


class Student:
    """One submission in the sandbox. `student.f` is the function f of the contract."""

    def __init__(self, source: Source, assignment: Assignment, worker: Worker, attempt: Attempt = ONLY) -> None:
        self._forgiving, self._informed = attempt.forgiving, attempt.again
        self.calls: list[Call] = []  # of the check that is running
        self.skipped: list[str] = []  # notebook cells
        self._source, self._assignment, self._worker = source, assignment, worker
        self._cells: dict[tuple[str, ...], Cell] = {}  # by what may not be called in it
        self._defined: set[str] = set()
        self._broken: dict[str, dict[str, Any]] = {}  # functions that hung or crashed, and how
        self.worked: set[str] = set()  # functions that have returned what was promised: it depends on the input
        self._cpu, self._lasted = 0.0, 0.0  # s of CPU and on the wall's clock, of the cells that have ended

    def __getattr__(self, name: str) -> "Function":
        if name not in self._assignment.results:
            raise AttributeError(f"the contract of {self._assignment.slug} has no function {name}")
        return Function(self, name, self._assignment.results[name])

    @contextmanager
    def aside(self) -> Iterator[None]:
        """What is called in this block chooses words: it is not judged, and no function is given up for it."""
        running = current()
        calls, broken, function, case = list(self.calls), dict(self._broken), running.function, running.case
        try:
            yield
        finally:
            self.calls, self._broken, running.function, running.case = calls, broken, function, case

    def load(self) -> None:
        """Import the submission, or raise NotLoaded."""
        self._cell(())

    def seconds(self) -> float:
        """CPU seconds that the submission has used."""
        return self._cpu + sum(cell.seconds() for cell in self._cells.values())

    def leave(self) -> None:
        """End the submission's processes."""
        for cell in self._cells.values():
            cell.drop()
        self._cells.clear()

    @property
    def text(self) -> str:
        """What was handed in, as far as it is text."""
        return self._source.text.decode("utf-8", "replace")

    def replies(self, name: str, calls: Sequence[Given], mode: str = "value", **more: Any) -> list[dict[str, Any]]:
        """One reply for each call up to the first error; Failed if the function hangs or ends its process.

        more : fields of the request; every=True asks for the calls behind an error, too
        """
        if name in self._broken:
            raise Failed(**self._broken[name])
        banned, results = self._assignment.off_limits.get(name, ()), self._assignment.results
        refused = [one for one in banned if one in results]  # functions of the file; the rest are modules
        uncallable = tuple(one for one in banned if one not in results)
        cell = self._cell(uncallable)
        if name not in self._defined:
            raise NotWritten(name)
        replies: list[dict[str, Any]] = []
        try:
            cell.send(request([one.message for one in calls], function=name, mode=mode, refused=refused, **more))
            while len(replies) < len(calls) and (more.get("every") or not (replies and "error" in replies[-1])):
                replies.append(cell.receive(lambda reply: checked(reply, mode)))
                self._must_end()
        except CellTimeout:
            slow = f"{name} did not return within {self._worker.allowance.call:g} s"
            self._end(uncallable, name, slow, calls[len(replies)])
        except CellLost:
            how = "it exited, crashed or used too much memory"
            self._end(uncallable, name, f"{name} ended its process: {how}", calls[len(replies)])
        return replies

    def _must_end(self) -> None:
        """Raise BudgetSpent for one that costs us its time to read, or sleeps through its calls and holds up the class.

        The processor time of a call is its cell's to limit.
        """
        read = self._cpu + sum(cell.read for cell in self._cells.values())
        if read > (most := self._worker.allowance.cpu):
            raise BudgetSpent(f"the submission has used its {most:g} s of processor time")
        lasted = self._lasted + sum(cell.lasted for cell in self._cells.values())
        if lasted > (most := PATIENCE * self._worker.allowance.cpu):
            raise BudgetSpent(f"the submission has taken {most:g} s, and used little processor time")

    def _end(self, uncallable: tuple[str, ...], name: str, says: str, call: Given) -> None:
        """End a cell: the function fails from now on, the others get a new cell while there is CPU time."""
        self._end_cell(self._cells.pop(uncallable))
        kind = call.kind if name in self.worked else ""
        why: dict[str, Any] = {"says": says, "kind": kind, "at": call, "function": name}
        self._broken[name] = why
        self._must_end()
        if self._cpu >= (most := self._worker.allowance.cpu) - 0.5:
            raise BudgetSpent(f"the submission has used its {most:g} s of processor time")
        raise Failed(**why)

    def _end_cell(self, cell: Cell) -> None:
        """End a cell and count its CPU time; WorkerLost if it died with its worker, or by another's hand."""
        self._cpu += cell.end() + cell.read
        self._lasted += cell.lasted
        if not cell.guarded:
            self._worker.must_live()
        if self._forgiving and (cell.killed_from_outside or not cell.guarded):
            raise WorkerLost("the submission was killed by another process")

    def _cell(self, uncallable: tuple[str, ...]) -> Cell:
        """The cell for functions that may not call these modules, with the submission loaded."""
        if uncallable not in self._cells:
            hidden = [*self._assignment.off_limits.get("*", ()), *uncallable]
            cell = self._worker.cell(self._worker.allowance.cpu - self._cpu, hidden)
            try:
                self._load(cell, uncallable)
            except NotLoaded:
                self._end_cell(cell)
                raise
            self._cells[uncallable] = cell
            self._must_end()
        return self._cells[uncallable]

    def _load(self, cell: Cell, uncallable: tuple[str, ...]) -> None:
        try:
            cell.send(
                {
                    "source": self._source.text,
                    "notebook": self._source.notebook,
                    "name": self._assignment.slug,
                    "functions": list(self._assignment.results),
                    "uncallable": list(uncallable),
                    "forbidden": list(self._assignment.off_limits.get("*", ())),
                }
            )
            compiled = cell.receive(imported)
            reply = compiled if "error" in compiled else cell.receive(imported)
        except CellTimeout:
            slow = "importing the file took too long: does it run a simulation by itself?"
            raise NotLoaded("timeout", slow) from None
        except CellLost:
            raise NotLoaded("crashed", "importing the file ended its process") from None
        text, again = self._source.text, self._informed
        if "error" in compiled:
            raise not_compiled(compiled)
        if "error" in reply:
            raise not_imported(reply, text, self._assignment, again)
        self._defined = set(reply["names"])
        if not again:
            self.skipped = [*map(printable, compiled["names"]), *skipped_cells(reply["skipped"], text)]
        self._informed = True


@dataclass(frozen=True)
class Function:
    """A student's function of the contract."""

    student: Student
    name: str
    promise: Any

    def __call__(self, *args: Any, **kwargs: Any) -> Any:
        """The result of one call, in the promised form."""
        return self.many([given(*args, **kwargs)])[0]

    def each(self, calls: Iterable[Given]) -> Iterator[tuple[Given, Any]]:
        """Every call with its result; the one at hand is the trial's case, for what `expect` says of it.

        Of a formula the value, where the call's keywords are the symbols.
        """
        calls = list(calls)
        symbolic = isinstance(self.promise, Formula)
        results = self.at([call.kwargs for call in calls]).tolist() if symbolic else self.many(calls)
        for call, found in zip(calls, results, strict=True):
            current().judge(self.name, call)
            yield call, found

    def many(self, calls: Sequence[Given]) -> list[Any]:
        """The results of many calls, made in one round trip."""
        results = []
        for call, reply in zip(calls, self.student.replies(self.name, calls), strict=False):
            self.student.calls.append(Call(self.name, call, None))
            with self._judging(call):
                self._must_be_fair(reply)
                results.append(result(self.promise, reply["value"], self.name, call))
            self.student.worked.add(self.name)
            self.student.calls[-1] = Call(self.name, call, results[-1])
        return results

    def aside(self, call: Given) -> Any:
        """The result of a call that is made to choose the words: see `Student.aside`."""
        with self.student.aside():
            return self(*call.args, **call.kwargs)

    def refusals(self, calls: Iterable[Given]) -> Iterator[tuple[Given, bool]]:
        """Every call, and whether it raises ValueError; another exception is Failed."""
        calls = list(calls)
        for call, reply in zip(calls, self.student.replies(self.name, calls, every=True), strict=True):
            refused = "ValueError" in error_of(reply)["kinds"]
            with self._judging(call, promised=", not ValueError"):
                if not refused:
                    self._must_be_fair(reply)
            yield call, refused

    def at(self, points: Sequence[Mapping[str, float]]) -> np.ndarray:
        """Values of the formula that the function returns, at each of these points: {symbol's name: number}."""
        if not isinstance(self.promise, Formula):
            raise TypeError(f"{self.name} does not promise a formula")
        symbols = list(self.promise.symbols)
        asked = {"symbols": symbols, "points": [dict(point) for point in points]}
        reply = self.student.replies(self.name, [given()], "formula", **asked)[0]
        with self._judging(case := given(list(points))):
            self._must_be_fair(reply)
            numbers = self._values(reply["value"], len(points))
        self.student.calls.append(Call(self.name, case, numbers))
        return numbers

    def _values(self, values: Any, count: int) -> np.ndarray:
        """The real numbers that a formula has at so many points, or Failed."""
        if not isinstance(values, list) or len(values) != count:
            strange = _strangers(values, self.student.text)
            says = f"{self.name} does not return a SymPy expression in {', '.join(self.promise.symbols)} alone"
            raise Failed(says, hint=strange and f"It has {strange} in it.")
        try:
            numbers = np.array([complex(value) for value in values])
        except (TypeError, ValueError):
            raise Failed(f"the expression of {self.name} has no value at some numbers", actual=values) from None
        if not np.all(np.isfinite(numbers)) or np.any(np.abs(numbers.imag) > REAL * np.abs(numbers) + ROUNDING):
            raise Failed(f"the expression of {self.name} is not real and finite at some numbers", actual=numbers)
        return numbers.real

    def drawn(self, call: Given, moved: str | None = None) -> Drawing:
        """The curves that the plot function draws in a case, where the results of one function may be moved by one."""
        reply = self.student.replies(self.name, [call], "drawing", moved=moved)[0]
        with self._judging(call):
            self._must_be_fair(reply)
            if reply["value"] is None:
                raise Failed(f"{self.name} draws too much, or nothing that can be read")
        self.student.worked.add(self.name)
        return readable(reply["value"])

    @contextmanager
    def _judging(self, call: Given, promised: str = "") -> Iterator[None]:
        """Judge the result of a call: a failure says which call it was, and its kind if the function works for another.

        promised : what it must raise instead, for any input of this kind
        """
        current().judge(self.name, call)
        try:
            yield
        except Failed as failed:
            why, worked = failed.failure, promised or self.name in self.student.worked
            kind = call.kind if worked else ""
            failed.failure = replace(why, says=why.says + promised, function=self.name, kind=kind, at=call)
            raise

    def _must_be_fair(self, reply: dict[str, Any]) -> None:
        """Raise NotWritten or Failed for an exception, and for arguments changed in place."""
        if "error" in reply:
            error = error_of(reply)
            if error["kinds"][:1] == ["NotImplementedError"]:
                raise NotWritten(self.name)
            raise Failed(_raised(self.name, error, self.student._assignment), actual=error["text"])
        if reply.get("changed"):
            raise Failed(f"{self.name} changes the arrays it is given", hint="Work on copies")


def _strangers(value: Any, source: str) -> str:
    """A symbol of a formula that the contract does not know, if it is a word that the student wrote down.

    The name of a symbol may be made at run time, of hidden inputs: no other is told, and but one.
    """
    names: Any = value.get("strangers") if isinstance(value, dict) else None
    words = [name for name in names if re.fullmatch(STRANGER, name)] if strings(names) else []
    return next((name for name in words if re.search(rf"\b{name.removesuffix('(t)')}\b", source)), "")


def _raised(name: str, error: dict[str, Any], assignment: Assignment) -> str:
    if "Forbidden" in error["kinds"]:
        banned = [*assignment.off_limits.get(name, ()), *assignment.off_limits.get("*", ())]
        named = [one for one in banned if error["text"].startswith(f"{one} ")]  # the text is the submission's
        return f"{name} uses what is off limits in it: {' or '.join(named or banned)}"
    return f"{name} {started(error['text']) or 'raised ' + python_class(error)}"
