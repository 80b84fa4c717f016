"""Judge results in a check: `expect` compares numbers, `expect_that` takes any condition.

Both write to the context of the running check, which has the current case and its label, so that a check need not
repeat them. An error that leaves a share of the points does not end the check: the smallest share of all cases counts.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, contextmanager, nullcontext, suppress
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

NEAR_MISS = 10  # tolerances: wrong physics has a larger error, a loose tolerance often a smaller one
NEAR_MISS_SHARE = 0.9  # of the points, if the result is right except for a loose tolerance
LONGEST_FAULT = 400  # characters of an exception in the grader
Hint = str | Callable[[], str]


class FollowsFrom(str):
    """Value in place of a hint: the student's wrong function from whose results the failed one follows correctly."""


class Failed(Exception):
    """The student's result is wrong; `share` of the points is left."""

    def __init__(self, message: str = "", *, share: float = 0.0, **fields: Any) -> None:
        super().__init__(message or fields.get("quantity", ""))
        self.failure, self.share = Failure(message=message, **fields), share


class NotWritten(Exception):
    """The function is missing, or is still the stub."""


@dataclass
class CheckContext:
    """State of a running check: current case, failures that leave a share of the points, recorders of comparisons."""

    case: Case | None = None
    function: str = ""  # the function called with it
    failures: list[tuple[Failed, Hint]] = field(default_factory=list)
    recorder: Callable[[float], None] | None = None  # called with each error / tolerance; then nothing fails
    aside: Callable[[], AbstractContextManager[None]] = nullcontext  # context for calls that choose the message
    examples: list[Json] | None = None  # if it is a list, each comparison is appended
    wrong_before: bool = False  # whether a check that this one builds on found wrong numbers
    is_rehearsal: bool = False  # no submission yet: comparisons use the expected results as the student's

    @property
    def listens(self) -> bool:
        """Whether each comparison must be reported, passed or failed."""
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
        """Append what a student's result is compared with to `examples`, from which students get example calls."""
        if self.examples is not None:
            part = {"member": member, "columns": columns, "expected": expected, **limits}
            self.examples.append({"function": function.name, "case": case, "compare": part})

    def set_call(self, function: str, case: Case) -> None:
        """Set the call whose result is compared from now on."""
        self.function, self.case = function, case

    def fail(self, failed: Failed, hint: Hint) -> None:
        """Store a failure that leaves a share of the points; raise any other."""
        if failed.share <= 0:
            raise self._explained(failed, hint)
        self.failures.append((failed, hint))

    def end(self) -> None:
        """Raise the stored failure that leaves the smallest share, if there is one."""
        if self.failures:
            raise self._explained(*min(self.failures, key=lambda failure: failure[0].share))

    def _explained(self, failed: Failed, hint: Hint) -> Failed:
        """Return the failure to be reported, with its hint, which may take long to compute.

        If the grader fails to choose the hint, `fault` says why: this must not cost a grade.
        """
        said = fault = ""
        try:
            with suppress(Failed, NotWritten, Exhausted), self.aside():  # from calls that are not graded
                said = hint() if callable(hint) else hint
        except MemoryError:
            raise
        except Exception as error:
            fault = repr(error)[:LONGEST_FAULT]
        source = said if isinstance(said, FollowsFrom) else ""
        failed.failure = replace(failed.failure, hint="" if source else said, follows_from=str(source), fault=fault)
        return failed


_current: ContextVar[CheckContext] = ContextVar("context")


def get_context() -> CheckContext:
    """Return the context of the running check; a new one if a check is called by hand."""
    return _current.get(None) or CheckContext()


@contextmanager
def check_context(**fields: Any) -> Iterator[CheckContext]:
    """Run a check in a context with these fields; at its end raise the failure that leaves the smallest share."""
    running = CheckContext(**fields)
    token = _current.set(running)
    try:
        yield running
        running.end()
    finally:
        _current.reset(token)


def expect(  # noqa: PLR0913  options of a comparison, passed by name
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

    quantity, unit : what is compared, for the message; with a scale, the unit names it ("of the energy")
    hint     : where to look; a function is called only on failure
    t        : times along the first axis of actual; the message names the time of the largest error
    partial  : {limit: share of the points} for larger errors, or a function of the error; up to NEAR_MISS tolerances
               NEAR_MISS_SHARE is left
    label, at : the label of the input and the input, if they are not those of the last call
    near_miss_credit : False if an error of a few tolerances is no sign that the physics is right
    keeps    : called on failure; returns the `curve` of an invariant along the student's motion
    """
    actual, expected = np.asarray(actual, float), np.asarray(expected, float)
    errors = distance(actual, expected) / scale
    worst = int(np.argmax(errors)) if errors.size else 0  # the first NaN, if there is one
    error = float(errors.flat[worst]) if errors.size else np.nan
    if recorder := get_context().recorder:
        over_limit = error / tolerance if tolerance else np.inf if error else 0.0  # 0: a number must be exact
        recorder(np.inf if np.isnan(error) else over_limit)
    elif not error <= tolerance:
        numbers = {"error": error, "limit": tolerance, "expected": expected, "actual": actual}
        if t is not None:
            row = int(np.unravel_index(worst, errors.shape)[0])
            numbers["time"] = float(f"{t[row]:.2g}")
            plotted = curve(t, actual, expected, scale, tolerance=tolerance, quantity=quantity, unit=unit)
            numbers["curve"] = {**plotted, "keeps": keeps()} if plotted and keeps else plotted
        share = _share(error, tolerance if near_miss_credit else 0.0, partial)
        # if a function leaves a share for a larger error, the physics is right: dependent checks run
        numbers["near_miss"] = near_miss_credit and (
            error <= NEAR_MISS * tolerance or (callable(partial) and share > 0)
        )
        fail("", quantity=quantity, unit=unit, hint=hint, label=label, at=at, share=share, **numbers)


def expect_that(holds: object, message: str, *, hint: Hint = "", label: str | None = "") -> None:
    """Fail with `message` (what is wrong) unless the condition holds; label=None means: for any input."""
    if not holds:
        fail(message, hint=hint, label=label)


def fail(
    message: str, *, hint: Hint = "", label: str | None = "", at: object = None, share: float = 0.0, **fields: Any
) -> None:
    """Fail with `message`; if a share is left, the check continues."""
    running = get_context()
    case = running.case
    fields |= {"label": (case.label if case and label == "" else label) or "", "at": case if at is None else at}
    running.fail(Failed(message, function=running.function, share=share, **fields), hint)


def distance(actual: Numbers, expected: Numbers) -> Numbers:
    """Return the absolute difference; zero if both are the same infinity, which may be right."""
    with np.errstate(invalid="ignore"):
        return np.where(actual == expected, 0.0, np.abs(actual - expected))


def _share(error: float, tolerance: float, partial: Mapping[float, float] | Callable[[float], float] | None) -> float:
    """Return the share of the points for an error beyond the tolerance."""
    if callable(partial):
        return NEAR_MISS_SHARE if error <= NEAR_MISS * tolerance else partial(error)
    shares = {**(partial or {}), NEAR_MISS * tolerance: NEAR_MISS_SHARE}
    return max((share for limit, share in shares.items() if error <= limit), default=0.0)
