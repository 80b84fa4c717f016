"""Call a student's function in the sandbox, and check the form of each result."""

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field, replace
from itertools import islice, repeat
from typing import TYPE_CHECKING, Any

import numpy as np

from tam570.checking.transforms import parts
from tam570.formulas import REMEDIES
from tam570.values import Json, Numbers
from tam570_grader.checks.case import Call, Case
from tam570_grader.checks.expect import Failed, NotWritten, get_context
from tam570_grader.checks.plots import readable
from tam570_grader.checks.returns import Drawing, Formula, FreeBodyDiagram, result, results_alike
from tam570_grader.sandbox.imports import misused, named_exception, sentence_of_ban
from tam570_grader.sandbox.replies import error_of, strings

if TYPE_CHECKING:
    from tam570_grader.sandbox.student import Student

REAL = 1e-12  # largest imaginary part of a real value, relative; sums of complex exponentials leave some
ROUNDING = 1e-25  # largest imaginary part, absolute, if they cancel to zero
MISCALLED = re.compile(r"\S+\(\) (?:got|missing|takes) .*")  # Python's message about wrong arguments
BLOCK = re.compile(r"^(?:def|class) +([A-Za-z_]\w{0,39})\b", re.MULTILINE)  # a function or class of a file
MOST_BLOCKS = 50  # limits what the name of the function that raises can reveal about hidden inputs
MOST_SEARCHED = 100_000  # words of a file in which a symbol is looked for; one search serves all symbols
WORK_ON_COPIES = "Work on copies"
STRANGER = r"[A-Za-z]{1,12}(_?[A-Za-z0-9]{1,3})?(\(t\))?"  # a symbol's name, theta_1, or a function of time, theta(t)


@dataclass(frozen=True)
class SandboxFunction:
    """A student's function of the contract."""

    student: "Student"
    name: str
    returns: Any
    early: Mapping[bytes, Json] = field(default_factory=dict)  # replies to calls that `ahead` has made, by packed call

    def __call__(self, *args: Numbers, **kwargs: Numbers) -> Any:
        """Return the result of one call, in the form that the contract requires."""
        return self.many([Case(*args, **kwargs)])[0]

    def each(self, calls: Iterable[Case]) -> Iterator[tuple[Case, Any]]:
        """Yield each call with its result, and make it the context's case, to which the messages of `expect` refer."""
        calls = list(calls)
        for call, value in zip(calls, self.many(calls), strict=True):
            get_context().set_call(self.name, call)
            yield call, value

    def ahead(self, calls: Sequence[Case]) -> "SandboxFunction":
        """Return a copy of this function that already has the replies to these calls, made in one round trip."""
        replies = self.student.replies(self.name, calls, every=True)
        return replace(self, early=dict(zip([call.packed for call in calls], replies, strict=True)))

    def _replies(self, calls: Sequence[Case], every: bool = False) -> list[Json]:
        """Return a reply for each call; without `every`, none after the first error."""
        early = [self.early[call.packed] for call in calls if call.packed in self.early]
        if len(early) < len(calls):
            return self.student.replies(self.name, calls, every=every)
        first_error = next((number for number, reply in enumerate(early) if "error" in reply), len(early))
        return early if every else early[: first_error + 1]

    def many(self, calls: Sequence[Case]) -> list[Any]:
        """Return the results of many calls, made in one round trip.

        For a formula, return its values; the calls' keyword arguments are then the values of its symbols.
        """
        if isinstance(self.returns, Formula):
            return list(self.at([call.kwargs for call in calls]).tolist())
        replies = self._replies(calls)
        results = results_alike(self.returns, [reply["value"] for reply in replies if reply.get("changed") is False])
        if results is not None and len(results) == len(calls):
            get_context().set_call(self.name, calls[-1])
            self.student.calls += map(Call, repeat(self.name), calls, results)
            self.student.worked.add(self.name)
            return results
        results, first_failed = [], None
        for call, reply in zip(calls, replies, strict=False):
            self.student.calls.append(Call(self.name, call, None))
            try:
                with self._judging(call):
                    self._must_be_fair(reply)
                    results.append(result(self.returns, reply["value"], self.name, call))
            except Failed as failed:  # go on: the other results help to find the mistake
                first_failed = first_failed or failed
                if reply.get("changed") and not isinstance(self.returns, FreeBodyDiagram):
                    with suppress(Failed):
                        numbers = result(self.returns, reply["value"], self.name, call)
                        self.student.calls[-1] = Call(self.name, call, numbers)
                continue
            self.student.worked.add(self.name)
            if not isinstance(self.returns, FreeBodyDiagram):  # has no numbers for the diagnosis
                self.student.calls[-1] = Call(self.name, call, results[-1])
        if first_failed:
            get_context().set_call(self.name, first_failed.failure.at)
            raise first_failed
        return results

    def aside(self, call: Case) -> Any:
        """Return the result of a call that is not graded, made to choose the message: see `Student.aside`."""
        with self.student.aside(self.name):
            return self(*call.args, **call.kwargs)

    def uses(self, helper: str, call: Case) -> bool:
        """Return whether a call's result changes, or it fails, if the results of a helper are made larger by one."""
        key = self.name, helper, call.packed
        if key not in self.student.uses:
            self.student.uses[key] = self._depends(helper, call)
        return self.student.uses[key]

    def _depends(self, helper: str, call: Case) -> bool:
        with self.student.aside(self.name):
            replies = [self.student.replies(self.name, [call], moved=moved)[0] for moved in (None, helper)]
        if "value" not in replies[0]:
            return False
        before = parts(result(self.returns, replies[0]["value"], self.name, call))
        try:
            return not all(
                map(np.array_equal, before, parts(result(self.returns, replies[1]["value"], self.name, call)))
            )
        except (KeyError, Failed):
            return True

    def scaled(self, helper: str, index: int, factor: float, call: Case) -> Any:
        """Return a call's result if a helper's result, or one number of it, has this factor; None if the call fails.

        index : of the number; -1 for all
        """
        with self.student.aside(self.name):
            reply = self.student.replies(self.name, [call], moved=helper, scaled=[index, factor])[0]
        try:
            return result(self.returns, reply["value"], self.name, call)
        except (KeyError, Failed):
            return None

    def refusals(self, calls: Iterable[Case]) -> Iterator[tuple[Case, bool]]:
        """Yield each call and whether it raises ValueError; raise Failed if it raises another exception."""
        calls = list(calls)
        for call, reply in zip(calls, self._replies(calls, every=True), strict=True):
            refused = "error" in reply and "ValueError" in reply["error"]["kinds"]
            with self._judging(call, any_input=True):
                if not refused:
                    with suppress(Failed, KeyError):  # keep the result for the diagnosis
                        numbers = result(self.returns, reply["value"], self.name, call)
                        self.student.calls.append(Call(self.name, call, numbers))
                    self._must_be_fair(reply, expected=", not ValueError")
            yield call, refused

    def at(self, points: Sequence[Mapping[str, float]]) -> np.ndarray:
        """Return the values of the formula that the function returns, at points {name of a symbol: number}."""
        if not isinstance(self.returns, Formula):
            raise TypeError(f"{self.name} does not promise a formula")
        symbols = list(self.returns.symbols)
        request = {"symbols": symbols, "points": [dict(point) for point in points]}
        reply = self.student.replies(self.name, [Case()], "formula", **request)[0]
        with self._judging(case := Case(list(points))):
            self._must_be_fair(reply)
            numbers = self._values(reply["value"], len(points))
        self.student.calls.append(Call(self.name, case, numbers))
        return numbers

    def _values(self, values: Any, count: int) -> np.ndarray:
        """Return the real values of a formula at `count` points; raise Failed if the reply has none."""
        if not isinstance(values, list) or len(values) != count:
            if form := values.get("form") if isinstance(values, dict) else None:
                raise Failed(f"{self.name} returned {form} in place of a SymPy expression", hint=REMEDIES[form])
            strange = _strangers(values, self.student.text)
            message = f"{self.name} does not return a SymPy expression in {', '.join(self.returns.symbols)} alone"
            raise Failed(message, hint=strange and f"It has {strange} in it.")
        try:
            numbers = np.array([complex(value) for value in values])
        except (TypeError, ValueError):
            raise Failed(f"the expression of {self.name} has no value at some numbers", actual=values) from None
        if not np.all(np.isfinite(numbers)) or np.any(np.abs(numbers.imag) > REAL * np.abs(numbers) + ROUNDING):
            raise Failed(f"the expression of {self.name} is not real and finite at some numbers", actual=numbers)
        return numbers.real

    def drawn(self, call: Case, moved: str | None = None) -> Drawing:
        """Return what the plot function draws; `moved` names a function of the file whose results are larger by one."""
        reply = self.student.replies(self.name, [call], "drawing", moved=moved)[0]
        with self._judging(call):
            self._must_be_fair(reply)
            if reply["value"] is None:
                raise Failed(f"{self.name} draws too much, or nothing that can be read")
        self.student.worked.add(self.name)
        return readable(reply["value"])

    @contextmanager
    def _judging(self, call: Case, any_input: bool = False) -> Iterator[None]:
        """Add the call to a Failed of the block, and its label if the function has worked for another input.

        any_input : add the label in any case
        """
        get_context().set_call(self.name, call)
        try:
            yield
        except Failed as failed:
            label = call.label if any_input or self.name in self.student.worked else ""
            failed.failure = replace(failed.failure, function=self.name, label=label, at=call)
            raise

    def _must_be_fair(self, reply: Json, expected: str = "") -> None:
        """Raise NotWritten or Failed if the function raised an exception, or changed its arguments in place.

        expected : text for the message on another exception than the required one, such as ", not ValueError"
        """
        if "error" in reply:
            error = error_of(reply)
            if error["kinds"][:1] == ["NotImplementedError"]:
                raise NotWritten(self.name)
            source = _block(self.student.text, error["line"])
            hint = f"It was raised in {source}, which {self.name} calls" if source not in ("", self.name) else ""
            raise Failed(f"{self.name} {self._did(error, expected)}", actual=error["text"], hint=hint)
        if reply.get("changed") and not self.student.may_change:
            raise Failed(f"{self.name} changes the arrays it is given", hint=WORK_ON_COPIES)

    def _did(self, error: Json, expected: str) -> str:
        """Return what the function did instead of returning, without text that the student may have written."""
        if "Forbidden" in error["kinds"]:
            forbidden = self.student.assignment.forbidden
            banned = [*forbidden.get(self.name, ()), *forbidden.get("*", ())]
            return f"uses what is off limits in it: {misused(error, banned)}"
        if error["kinds"][:1] == ["TypeError"] and error["line"] == 0 and MISCALLED.fullmatch(error["text"]):
            return f"must take ({self.student.assignment.signature(self.name)})"
        return sentence_of_ban(error["text"]) or f"raised {named_exception(error)}{expected}"


def _block(text: str, line: int) -> str:
    """Return the function or class that contains a line; "" if that is unclear, or there are over MOST_BLOCKS."""
    lines = text.splitlines()[:line]
    names = BLOCK.findall("\n".join(lines))
    return names[-1] if lines and lines[-1][:1].isspace() and 0 < len(names) <= MOST_BLOCKS else ""


def _strangers(value: object, source: str) -> str:
    """Return a symbol of a formula that the contract does not have, if its name is a word in the student's file.

    A submission can compute names of symbols from hidden inputs, so no other name is revealed, and only one.
    """
    names: Any = value.get("strangers") if isinstance(value, dict) else None
    words = {match[0] for match in islice(re.finditer(r"\w+", source), MOST_SEARCHED)}
    symbols = [name for name in names if re.fullmatch(STRANGER, name)] if strings(names) else []
    return next((name for name in symbols if name.removesuffix("(t)") in words), "")
