"""What hidden checks are written with: check, expect, expect_that, suspect, given, once.

A check is a plain function `name(student, draw)` whose docstring is the line that the student reads:

    @check(points=2, part="a", after=other_check, suspects=[suspect("the transpose", rotation_matrix=transposed)])
    def keeps_lengths(student, draw):
        "R^T R = I, for any axis and angle."
        for axis, angle in axes_and_angles(draw, 50):
            R = student.rotation_matrix(axis, angle)
            expect(R.T @ R, np.eye(3), within=1e-12, of="R^T R", at=(axis, angle), kind="any axis")

`student.f(...)` calls the student's function in the sandbox and returns what RESULTS promises, as float64
arrays, or ends the check with a message; `student.f.many([given(...), ...])` makes many calls in one round
trip; `student.f.refuses(...)` tells whether a call raises ValueError. `student.on("a half turn").f(...)` and
`given(...).on("a half turn")` let the message say for what kind of input a call raises or returns no numbers.
`draw` is a random generator that belongs to the check and is the same for every student of a run.
"""

import functools
import threading
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, TypeVar

import numpy as np

from tam570_grader.writing.curves import Curve, curve

__all__ = ["Check", "Failure", "Given", "Suspect", "check", "expect", "expect_that", "given", "once", "suspect"]

T = TypeVar("T")
# values that `once` keeps, and answers of a suspect; with inputs of its own for each student a run makes thousands
MOST_KNOWN, MOST_ANSWERS = 64, 16


class Memory:
    """The last values computed, by their keys: each is computed for whoever asks first."""

    def __init__(self, most: int) -> None:
        self._most, self._known, self._lock = most, dict[Any, Any](), threading.Lock()

    def value(self, key: Any, compute: Callable[[], Any]) -> Any:
        """The value of this key; what is returned is shared, and not to be changed."""
        with self._lock:
            if key not in self._known:
                self._known[key] = compute()
                if len(self._known) > self._most:
                    del self._known[next(iter(self._known))]
            return self._known[key]


@dataclass(frozen=True)
class Suspect:
    """A known wrong answer: what to say of it, and the wrong functions by the name of the right ones."""

    says: str
    variants: Mapping[str, Callable[..., Any]]
    within: float  # largest difference, relative to the largest number of the wrong answer
    answers: Memory = field(default_factory=lambda: Memory(MOST_ANSWERS), compare=False, repr=False)


@dataclass(frozen=True)
class Check:
    """One hidden check, as `@check` makes it."""

    judge: Callable[[Any, np.random.Generator], None]
    points: float
    part: str
    after: tuple[str, ...]
    suspects: tuple[Suspect, ...]

    @property
    def name(self) -> str:
        return self.judge.__name__

    @property
    def line(self) -> str:
        """What the check tests, for the student: the first paragraph of its docstring on one line."""
        return " ".join((self.judge.__doc__ or self.name).strip().split("\n\n")[0].split())


def check(
    *, points: float, part: str, after: Check | Sequence[Check] = (), suspects: Iterable[Suspect] = ()
) -> Callable[[Callable[[Any, np.random.Generator], None]], Check]:
    """Make a function a check worth `points` in a lettered part, run only when all of `after` have passed."""
    needed = (after,) if isinstance(after, Check) else tuple(after)

    def made(judge: Callable[[Any, np.random.Generator], None]) -> Check:
        return Check(judge, float(points), part, tuple(other.name for other in needed), tuple(suspects))

    return made


def suspect(says: str, *, within: float = 1e-6, **variants: Callable[..., Any]) -> Suspect:
    """A wrong answer to name: `says` completes "matches the result with ...".

    A variant takes the arguments of the student's function and returns the wrong result; that of a formula takes
    the points and returns the values. The suspect is
    named when the student's results agree with it in every call that the failed check made to those functions.
    """
    return Suspect(says, variants, within)


class Failure(Exception):
    """The student's result is wrong. Message and picture are the student's; the other fields are the instructor's."""

    def __init__(
        self,
        message: str,
        *,
        fraction: float = 0.0,
        expected: Any = None,
        actual: Any = None,
        at: Any = None,
        picture: Curve | None = None,
    ) -> None:
        super().__init__(message)
        self.message = message
        self.fraction = fraction
        self.picture = picture
        self.expected = expected
        self.actual = actual
        self.at = at

    def __str__(self) -> str:
        return self.message


@dataclass(frozen=True)
class Given:
    """The arguments of one call, and the kind of input that they are."""

    args: tuple[Any, ...] = ()
    kwargs: Mapping[str, Any] = field(default_factory=dict)
    kind: str = ""

    def on(self, kind: str) -> "Given":
        """The same arguments, of which the student is told the kind if the call itself fails."""
        return Given(self.args, self.kwargs, kind)


def given(*args: Any, **kwargs: Any) -> Given:
    """The arguments of one call, for `student.f.many`."""
    return Given(args, kwargs)


def expect(
    actual: Any,
    expected: Any,
    *,
    within: float,
    scale: Any = 1.0,
    of: str = "the result",
    unit: str = "",
    t: Any = None,
    kind: str = "",
    hint: str | Callable[[], str] = "",
    at: Any = None,
    partial: Mapping[float, float] | None = None,
    keeps: Callable[[], Curve | None] | None = None,
) -> None:
    """Fail unless every abs(actual - expected) / scale is at most `within`; a NaN fails.

    of, unit : what is compared and its unit, for the message; with a scale the unit says of what ("of the energy")
    t        : times along the first axis of actual; the message names the time of the largest error
    kind     : the kind of input, in words that give no input away; `at` is the input itself, for the instructor
    hint     : where to look; a function is asked on failure, to look closer at the result than is worth it before
    partial  : {limit: fraction of the points} for errors above `within`; such an expect must be a check's last
    keeps    : `kept(...)`, asked for on failure: what becomes of an invariant along the student's motion
    """
    actual, expected = np.asarray(actual, float), np.asarray(expected, float)
    errors = np.abs(actual - expected) / scale
    # with a NaN among them the maximum is NaN, and not below anything
    if errors.size and errors.max() <= within:
        return
    worst = _worst(errors)
    error = float(errors.flat[worst]) if errors.size else np.nan
    where = [_time(t, errors, worst)] if t is not None else []
    where += [f"for {kind}"] if kind else []
    says = f"{of} is off by {_two_digits(error)}{' ' + unit if unit else ''} (allowed {within:.0e})"
    message = _hinted(" ".join([says, *where]), hint)
    fraction = max((f for limit, f in (partial or {}).items() if error <= limit), default=0.0)
    picture = None if t is None else curve(t, actual, expected, scale, within=within, of=of, unit=unit)
    if picture and keeps:
        picture["keeps"] = keeps()
    raise Failure(message, fraction=fraction, expected=expected, actual=actual, at=at, picture=picture)


def expect_that(holds: Any, says: str, *, kind: str = "", hint: str | Callable[[], str] = "", at: Any = None) -> None:
    """Fail with `says` (what is wrong) unless the condition holds."""
    if holds:
        return
    raise Failure(_hinted(f"{says}{f' for {kind}' if kind else ''}", hint), at=at)


def _hinted(says: str, hint: str | Callable[[], str]) -> str:
    told = hint() if callable(hint) else hint
    return f"{says}; {told}" if told else says


def _worst(errors: Any) -> int:
    """Flat index of the largest error, a NaN being larger than any."""
    return int(np.argmax(np.where(np.isnan(errors), np.inf, errors))) if errors.size else 0


def _time(t: Any, errors: Any, worst: int) -> str:
    row = int(np.unravel_index(worst, errors.shape)[0])
    return f"at t = {float(f'{t[row]:.2g}'):g} s"


def _two_digits(error: float) -> str:
    return f"{error:.1e}" if np.isfinite(error) else "more than any number"


def once(compute: Callable[..., T]) -> Callable[..., T]:
    """Compute `compute(draw, ...)` a single time a run, however many students are graded.

    The generator is left as the computation left it, so a check draws the same numbers with and without it.
    What is returned is shared between students: do not change it.
    """
    known = Memory(MOST_KNOWN)

    @functools.wraps(compute)
    def remembered(draw: np.random.Generator, *args: Any) -> T:
        key = (repr(draw.bit_generator.state), *args)
        value, draw.bit_generator.state = known.value(key, lambda: (compute(draw, *args), draw.bit_generator.state))
        return value  # type: ignore[no-any-return]

    return remembered
