"""What hidden code may spend, counted: calls of its functions, turns of its loops, steps of `solve`.

A clock would let the speed of a machine choose the grade and its words; a count is the same everywhere.

    with limited(1000):
        function()  # raises Exhausted at its 1001st step, if it counts its steps
"""

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass


class Exhausted(Exception):
    """So much is not spent on one submission."""


@dataclass(slots=True)
class Meter:
    """Steps that are left."""

    remaining: int


_meter: ContextVar[Meter | None] = ContextVar("meter", default=None)


@contextmanager
def limited(steps: int) -> Iterator[Meter]:
    """Raise Exhausted in this block beyond so many steps; they also count in a block around it."""
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
    """Return whether steps are counted."""
    return _meter.get() is not None


def count(steps: int = 1) -> None:
    """Spend steps of the innermost block."""
    if meter := _meter.get():
        meter.remaining -= steps
        if meter.remaining < 0:
            raise Exhausted
