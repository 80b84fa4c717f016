"""What a check says of a result: `expect` compares numbers, `expect_that` takes any condition.

Both write to the context of the check that is running. It knows the input at hand and its label, so that a check need
not repeat them. An error that leaves a share of the points does not end the check: the smallest of all cases counts.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, contextmanager, nullcontext
from contextvars import ContextVar
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from tam570.meter import Exhausted
from tam570.values import Json, Numbers
from tam570_grader.checks.case import Case
from tam570_grader.checks.curves import Curve, curve
from tam570_grader.checks.failure import Failure
from tam570_grader.checks.student import StudentFunction

NEAR_MISS = 10  # limits: wrong physics lies further off, a loose tolerance is often nearer
NEAR_MISS_SHARE = 0.9  # of the points, for what is right but for a loose tolerance
LONGEST_FAULT = 400  # characters of an exception of ours
Hint = str | Callable[[], str]


class FollowsFrom(str):
    """In the place of a hint: the student's own wrong function, whose results the failed one rightly continues."""


class Failed(Exception):
    """The student's result is wrong; a share of the points may be left."""

    def __init__(self, message: str = "", *, share: float = 0.0, **fields: Any) -> None:
        super().__init__(message or fields.get("quantity", ""))
        self.failure, self.share = Failure(message=message, **fields), share


class NotWritten(Exception):
    """The function is not there, or is still the stub."""


@dataclass
class CheckContext:
    """A check as it runs: the case at hand, the failures that leave a share of the points, who listens to errors."""

    case: Case | None = None
    function: str = ""  # that the case was given to
    failures: list[tuple[Failed, Hint]] = field(default_factory=list)
    recorder: Callable[[float], None] | None = None  # told every error over its limit; nothing fails then
    aside: Callable[[], AbstractContextManager[None]] = nullcontext  # in which calls are made that choose the words
    examples: list[Json] | None = None  # what is compared is noted here, call by call, if it is a list
    wrong_before: bool = False  # a check that this one builds on found wrong numbers
    is_rehearsal: bool = False  # before there is a submission: comparisons take what is right for its results

    @property
    def listens(self) -> bool:
        """Whether each comparison is to be told of."""
        return self.recorder is not None or self.examples is not None

    def add_example(
        self,
        function: StudentFunction,
        case: Case,
        member: int | None,
        columns: Sequence[int] | None,
        expected: Numbers,
        **limits: Numbers,
    ) -> None:
        """Note what a result of a student's function is compared with, for the examples that students have."""
        if self.examples is not None:
            part = {"member": member, "columns": columns, "expected": expected, **limits}
            self.examples.append({"function": function.name, "case": case, "compare": part})

    def set_call(self, function: str, case: Case) -> None:
        """From now on the result of this call is judged."""
        self.function, self.case = function, case

    def fail(self, failed: Failed, hint: Hint) -> None:
        """Keep a failure that leaves a share, else end the check with it."""
        if failed.share <= 0:
            raise self._explained(failed, hint)
        self.failures.append((failed, hint))

    def end(self) -> None:
        """Raise the failure that leaves the smallest share."""
        if self.failures:
            raise self._explained(*min(self.failures, key=lambda failure_and_check: failure_and_check[0].share))

    def _explained(self, failed: Failed, hint: Hint) -> Failed:
        """Return the one failure that is told, with its hint, which may take long to find."""
        said, fault = _said(hint, self)
        source = said if isinstance(said, FollowsFrom) else ""
        failed.failure = replace(failed.failure, hint="" if source else said, follows_from=str(source), fault=fault)
        return failed


_current: ContextVar[CheckContext] = ContextVar("context")


def get_context() -> CheckContext:
    """Return the context of the check that is running; a new one for a check that is called by hand."""
    return _current.get(None) or CheckContext()


@contextmanager
def check_context(**fields: Any) -> Iterator[CheckContext]:
    """Run a check in a context with these fields; at its end the smallest share of the points counts."""
    running = CheckContext(**fields)
    token = _current.set(running)
    try:
        yield running
        running.end()
    finally:
        _current.reset(token)


def expect(  # noqa: PLR0913  what a check says of a comparison, each by its name
    actual: Numbers,
    expected: Numbers,
    *,
    tolerance: float,
    quantity: str = "the result",
    unit: str = "",
    hint: Hint = "",
    scale: Numbers = 1.0,
    t: Numbers = None,
    partial: Mapping[float, float] | Callable[[float], float] | None = None,
    label: str = "",
    at: object = None,
    keeps: Callable[[], Curve | None] | None = None,
    near_miss_credit: bool = True,
) -> None:
    """Fail unless every abs(actual - expected) / scale is at most `tolerance`; a NaN fails.

    quantity, unit : what is compared, for the message; with a scale the unit says of what ("of the energy")
    hint     : where to look; a function is asked on failure alone
    t        : times along the first axis of actual; the message names the time of the largest error
    partial  : {limit: share of the points} for larger errors, or a function of the error; up to ten limits
               NEAR_MISS_SHARE is left
    label, at : the label of the input and the input, where they are not those of the call that was compared last
    near_miss_credit : False where an error of a few limits is no sign that the physics is right
    keeps    : asked for on failure: the `curve` of what becomes of an invariant along the student's motion
    """
    actual, expected = np.asarray(actual, float), np.asarray(expected, float)
    errors = distance(actual, expected) / scale
    worst = int(np.argmax(errors)) if errors.size else 0  # the first NaN, if there is one
    error = float(errors.flat[worst]) if errors.size else np.nan
    if recorder := get_context().recorder:
        over_limit = error / tolerance if tolerance else np.inf if error else 0.0  # 0 where a number must be exact
        recorder(np.inf if np.isnan(error) else over_limit)
    elif not error <= tolerance:
        numbers = {"error": error, "limit": tolerance, "expected": expected, "actual": actual}
        if t is not None:
            row = int(np.unravel_index(worst, errors.shape)[0])
            numbers["time"] = float(f"{t[row]:.2g}")
            plotted = curve(t, actual, expected, scale, tolerance=tolerance, quantity=quantity, unit=unit)
            numbers["curve"] = {**plotted, "keeps": keeps()} if plotted and keeps else plotted
        share = _share(error, tolerance if near_miss_credit else 0.0, partial)
        # a share that a function leaves of a larger error says that the physics is right: what builds on it is judged
        numbers["near_miss"] = near_miss_credit and (
            error <= NEAR_MISS * tolerance or (callable(partial) and share > 0)
        )
        fail("", quantity=quantity, unit=unit, hint=hint, label=label, at=at, share=share, **numbers)


def expect_that(holds: object, message: str, *, hint: Hint = "", label: str | None = "") -> None:
    """Fail with `message` (what is wrong) unless the condition holds; a label of None means: for any input."""
    if not holds:
        fail(message, hint=hint, label=label)


def fail(
    message: str, *, hint: Hint = "", label: str | None = "", at: object = None, share: float = 0.0, **fields: Any
) -> None:
    """Fail with `message`; with a share the check goes on."""
    running = get_context()
    case = running.case
    fields |= {"label": (case.label if case and label == "" else label) or "", "at": case if at is None else at}
    running.fail(Failed(message, function=running.function, share=share, **fields), hint)


def _said(hint: Hint, running: CheckContext) -> tuple[str, str]:
    """Return where to look, and what went wrong on our side in choosing it: no reason to lose a grade."""
    if not callable(hint):
        return hint, ""
    try:
        with running.aside():
            return hint(), ""
    except MemoryError:
        raise
    except (Failed, NotWritten, Exhausted):  # what the student's function does then is not judged
        return "", ""
    except Exception as error:
        return "", repr(error)[:LONGEST_FAULT]


def distance(actual: Numbers, expected: Numbers) -> Numbers:
    """Return the size of the difference; zero where both are infinite: infinity may be right."""
    with np.errstate(invalid="ignore"):
        return np.where(actual == expected, 0.0, np.abs(actual - expected))


def _share(error: float, tolerance: float, partial: Mapping[float, float] | Callable[[float], float] | None) -> float:
    """Of the points, for an error beyond the limit."""
    if callable(partial):
        return NEAR_MISS_SHARE if error <= NEAR_MISS * tolerance else partial(error)
    shares = {**(partial or {}), NEAR_MISS * tolerance: NEAR_MISS_SHARE}
    return max((share for limit, share in shares.items() if error <= limit), default=0.0)
