"""A check: a plain function `name(student, rng)` whose docstring is the line that the student reads.

    @check(points=2, part="a", after=other_check)
    def keeps_lengths(student, draw):
        "R^T R = I, for any axis and angle."
        for case, R in student.rotation_matrix.each(axes_and_angles(draw, 50)):
            expect(R.T @ R, np.eye(3), within=1e-12, of="R^T R")

`student.f(...)` calls the student's function in the sandbox and returns what RESULTS promises, as float64 arrays, or
ends the check with a message; `student.f.each([Case(...), ...])` makes many calls in one round trip. `rng` is a
random generator that belongs to the check and is the same for every student of a run.
"""

import functools
import re
import threading
from collections.abc import Callable, Container, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, TypeVar

import numpy as np

from tam570_grader.protocol.wire import packed

__all__ = ["Check", "Case", "Memory", "check", "Case", "needed", "once"]

T = TypeVar("T")
MOST_KNOWN = 64  # values that `once` keeps; with inputs of its own for each student a run makes thousands


class Memory:
    """The last values computed, by their keys: each is computed for whoever asks first.

    most : how many are kept; or how many bytes, if `size` tells those of a value
    """

    def __init__(self, most: int, size: Callable[[Any], int] = lambda value: 1) -> None:
        self._most, self._size, self._held = most, size, 0
        self._known, self._lock = dict[Any, Any](), threading.Lock()

    def value(self, key: Any, compute: Callable[[], Any]) -> Any:
        """The value of this key; what is returned is shared, and not to be changed."""
        with self._lock:
            if key not in self._known:
                value = self._known[key] = compute()
                self._held += self._size(value)
                while self._held > self._most and len(self._known) > 1:
                    self._held -= self._size(self._known.pop(next(iter(self._known))))
            return self._known[key]


@dataclass(frozen=True)
class Check:
    """One hidden check, as `@check` or a `law` makes it."""

    judge: Callable[[Any, np.random.Generator], None]
    points: float
    part: str
    after: tuple["Check", ...]

    @property
    def name(self) -> str:
        return self.judge.__name__

    @property
    def line(self) -> str:
        """What the check tests, for the student: the first paragraph of its docstring on one line."""
        return " ".join((self.judge.__doc__ or self.name).strip().split("\n\n")[0].split())

    def function(self, results: Container[str]) -> str:
        """The function that it is about: the first of `results` that its line names, empty if it names none."""
        return next((word for word in re.findall(r"\w+", self.line) if word in results), "")


def check(
    *, points: float, part: str, after: Check | Sequence[Check] = ()
) -> Callable[[Callable[[Any, np.random.Generator], None]], Check]:
    """Make a function a check worth `points` in a lettered part, run only when all of `after` have (nearly) passed."""

    def made(judge: Callable[[Any, np.random.Generator], None]) -> Check:
        return Check(judge, float(points), part, needed(after))

    return made


def needed(after: Check | Sequence[Check]) -> tuple[Check, ...]:
    """The checks that another builds on: one or several."""
    return (after,) if isinstance(after, Check) else tuple(after)


@dataclass(frozen=True)
class Case:
    """The arguments of one call, and the kind of input that they are."""

    args: tuple[Any, ...] = ()
    kwargs: Mapping[str, Any] = field(default_factory=dict)
    label: str = ""

    @functools.cached_property
    def message(self) -> bytes:
        """The arguments as they are sent: packed once for a class that shares them."""
        return packed([[*map(_sent, self.args)], {key: _sent(value) for key, value in self.kwargs.items()}])

    def labelled(self, label: str) -> "Case":
        """The same arguments, of which the student is told the kind."""
        return Case(self.args, self.kwargs, label)

    def replace(self, *args: Any, **kwargs: Any) -> "Case":
        """The same call with other leading arguments, or other parameters."""
        return Case((*args, *self.args[len(args) :]), {**self.kwargs, **kwargs}, self.label)

    def with_leading(self, *args: Any) -> "Case":
        """The same arguments behind others, of a function that takes more."""
        return Case((*args, *self.args), self.kwargs, self.label)


def _sent(value: Any) -> Any:
    """An argument as it is sent: any sequence of numbers is a float64 array, as the contract promises."""
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, np.ndarray):
        return value.astype(float)
    if isinstance(value, list | tuple) and value:
        if all(isinstance(item, int | float | np.number) for item in value):
            return np.array(value, float)
        return [_sent(item) for item in value]
    return list(value) if isinstance(value, tuple) else value


def Case(*args: Any, **kwargs: Any) -> Case:
    """The arguments of one call."""
    return Case(args, kwargs)


def once(compute: Callable[..., T], most: int = MOST_KNOWN) -> Callable[..., T]:
    """Compute `compute(rng, ...)` a single time a run, however many students are graded.

    The generator is left as the computation left it, so a check draws the same numbers with and without it.
    What is returned is shared between students: do not change it. `most` is how many values are kept.
    """
    known = Memory(most)

    @functools.wraps(compute)
    def remembered(rng: np.random.Generator, *args: Any, **named: Any) -> T:
        computed = functools.partial(compute, rng, *args, **named)
        key = (repr(rng.bit_generator.state), *args, *named.items())
        value, rng.bit_generator.state = known.value(key, lambda: (computed(), rng.bit_generator.state))
        return value  # type: ignore[no-any-return]

    return remembered
