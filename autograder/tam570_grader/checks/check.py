"""A check: a plain function `name(student, rng)` whose docstring is the line that the student reads.

    @check(points=2, part="a", after=other_check)
    def keeps_lengths(student, draw):
        "R^T R = I, for any axis and angle."
        for case, R in student.rotation_matrix.each(axes_and_angles(draw, 50)):
            expect(R.T @ R, np.eye(3), within=1e-12, of="R^T R")

`student.f(...)` calls the student's function in the sandbox and returns what `Assignment.returns` states, as float64
arrays, or ends the check with a message; `student.f.each([Case(...), ...])` makes many calls in one round trip. `rng`
is a random generator that belongs to the check and is the same for every student of a run.
"""

import functools
import re
import threading
from collections.abc import Callable, Container, Sequence
from dataclasses import dataclass
from typing import Any, TypeVar

import numpy as np

__all__ = ["Check", "Memory", "check", "needed", "once"]

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
