"""A budget for the grader's hidden code, in steps: function calls, passes of a loop, steps of `solve`.

A count is the same on every machine; with a time limit, grade and feedback would depend on the machine's speed.

    with limited(1000):
        function()  # raises Exhausted at its 1001st step, if it counts its steps
"""

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass


class Exhausted(Exception):
    """The budget of steps is spent."""


@dataclass(slots=True)
class Meter:
    """The number of steps left."""

    remaining: int

    @contextmanager
    def running(self) -> Iterator[None]:
        """Count the steps of a block in this meter, too, which limits several blocks together."""
        with limited(self.remaining) as meter:
            most = meter.remaining
            try:
                yield
            finally:
                self.remaining -= most - meter.remaining


_meter: ContextVar[Meter | None] = ContextVar("meter", default=None)


@contextmanager
def limited(steps: int) -> Iterator[Meter]:
    """Raise Exhausted in this block after more than `steps` steps; they also count in an enclosing block."""
    outer = _meter.get()
    most = min(steps, outer.remaining) if outer else steps
    meter = Meter(most)
    token = _meter.set(meter)
    try:
        yield meter
    finally:
        _meter.reset(token)
        if outer:
            outer.remaining -= most - meter.remaining


def is_limited() -> bool:
    """Return whether a block counts steps."""
    return _meter.get() is not None


def count(steps: int = 1) -> None:
    """Count steps in the innermost block; raise Exhausted beyond its limit."""
    if meter := _meter.get():
        meter.remaining -= steps
        if meter.remaining < 0:
            raise Exhausted
