"""A check: a plain function `name(student, rng)` about one function of the student.

    @check("rotation_matrix", points=2, part="a", after=other_check)
    def keeps_lengths(student, rng):
        '''R^T R = I, for any axis and angle.'''
        for case, R in student.rotation_matrix.each(cases.axes_and_angles(rng)):
            expect(R.T @ R, np.eye(3), tolerance=1e-12, quantity="R^T R")

`student.f(...)` calls the student's function in the sandbox and returns what `Assignment.returns` states, as float64
arrays, or ends the check with a message; `student.f.each([Case(...), ...])` makes many calls in one round trip. `rng`
is the check's random generator, which starts in the same state for every student of a run.
"""

import copy
import functools
import inspect
import threading
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from types import ModuleType
from typing import Any, Generic, TypeVar

import numpy as np

from tam570.values import Numbers

T = TypeVar("T")
MOST_KNOWN = 64  # cached values for each function of `once`; if inputs differ by student, a run makes thousands


class LruCache(Generic[T]):
    """Thread-safe cache of the most recently used values.

    most : largest number of values; or of bytes, if `size` returns the bytes of a value
    """

    def __init__(self, most: int, size: Callable[[T], int] = lambda value: 1) -> None:
        self._most, self._size, self._held = most, size, 0
        self._known, self._lock = dict[object, T](), threading.RLock()

    def value(self, key: object, compute: Callable[[], T]) -> T:
        """Return the value of a key, computed if it is not cached; callers share it and must not change it."""
        with self._lock:
            if key in self._known:
                self._known[key] = self._known.pop(key)  # to the end: the first is removed first
            else:
                value = self._known[key] = compute()
                self._held += self._size(value)
                while self._held > self._most and len(self._known) > 1:
                    self._held -= self._size(self._known.pop(next(iter(self._known))))
            return self._known[key]


Run = Callable[[Any, np.random.Generator], None]  # run(student, rng)


@dataclass(frozen=True)
class Check:
    """A hidden check, made by `@check`; `some_check.run(student, rng)` runs it by hand."""

    run: Run
    function: str  # the student's function that it is about
    points: float
    part: str
    line: str  # what it tests, as the student reads it
    after: tuple["Check", ...]
    refusals: bool = False

    @property
    def name(self) -> str:
        return self.run.__name__

    @property
    def title(self) -> str:
        """The line, with the function's name in front unless it begins with it."""
        return self.line if self.line.startswith(self.function) else f"{self.function}: {self.line}"


def check(
    function: str,
    *,
    points: float,
    part: str = "a",
    line: str = "",
    after: Check | Sequence[Check] = (),
    refusals: bool = False,
) -> Callable[[Run], Check]:
    """Return a decorator that makes a Check of a function `run(student, rng)`.

    Parameters
    ----------
    function : the student's function that the check is about
    points, part : its points, and the letter of its part
    line : what it tests, as the student reads it; default: the docstring of the function
    after : the check, or the checks, that must (nearly) pass before this one runs
    refusals : whether it tests what is refused; then it also runs if the checks before it found wrong numbers

    Raises
    ------
    ValueError
        If the function has neither a line nor a docstring.
    """
    before = (after,) if isinstance(after, Check) else tuple(after)

    def decorated(run: Run) -> Check:
        if not (text := line or " ".join((run.__doc__ or "").split())):
            raise ValueError(f"the check {run.__name__} needs a docstring: the line that the student reads")
        return Check(run, function, float(points), part, text, before, refusals)

    return decorated


def once(compute: Callable[..., T]) -> Callable[..., T]:
    """Return `compute(rng, ...)` with a cache, so that it runs once for all students; a list if it yields values.

    A cached call leaves the generator in the state after the computation, so that a check draws the same numbers.
    Students share cases; arrays, which a function of cases may go on to change, are copied for each call.
    """
    memory = LruCache[tuple[T, bool, Mapping[str, object]]](MOST_KNOWN)

    @functools.wraps(compute)
    def remembered(rng: np.random.Generator, *args: Numbers, **keywords: Numbers) -> T:
        def computed() -> tuple[T, bool, Mapping[str, object]]:
            value: Any = compute(rng, *args, **keywords)
            value = list(value) if isinstance(value, Iterator) else value
            return value, _can_be_altered(value), rng.bit_generator.state

        key = (repr(rng.bit_generator.state), *args, *keywords.items())
        value, is_mutable, rng.bit_generator.state = memory.value(key, computed) if _is_hashable(key) else computed()
        return copy.deepcopy(value) if is_mutable else value

    return remembered


def _can_be_altered(value: object) -> bool:
    """Return whether a value is or contains an array or dict, which can be changed in place; a Case cannot."""
    if isinstance(value, list | tuple):
        return any(map(_can_be_altered, value))
    return isinstance(value, np.ndarray | dict)


def _is_hashable(key: object) -> bool:
    try:
        hash(key)
    except TypeError:
        return False
    return True


def draw_once(module: ModuleType) -> None:
    """Wrap a module's functions of `rng` in `once`."""
    for name, value in inspect.getmembers(module, inspect.isfunction):
        if value.__module__ == module.__name__ and [*inspect.signature(value).parameters][:1] == ["rng"]:
            setattr(module, name, once(value))
