"""One formula, evaluated on plain floats or on arrays: single rotations stay cheap, batches stay fast.

A formula is a straight-line function `formula(f, *components)` of numbers. `f` holds the elementary
functions: those of `math` for one rotation (no array overhead), those of NumPy for a block of rotations,
component by component.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
Component = Any  # a float, or an array of floats with one entry per rotation
Formula = Callable[..., tuple[Component, ...]]

BLOCK = 4096  # rotations evaluated together: their components fit in the second-level cache


@dataclass(frozen=True)
class Functions:
    """The elementary functions a formula may use."""

    sin: Callable[..., Component]
    cos: Callable[..., Component]
    tan: Callable[..., Component]
    sqrt: Callable[..., Component]
    atan2: Callable[..., Component]
    hypot: Callable[..., Component]
    where: Callable[..., Component]


def _either(condition: bool, if_true: float, if_false: float) -> float:
    return if_true if condition else if_false


FLOATS = Functions(math.sin, math.cos, math.tan, math.sqrt, math.atan2, math.hypot, _either)
ARRAYS = Functions(np.sin, np.cos, np.tan, np.sqrt, np.arctan2, np.hypot, np.where)


@dataclass(frozen=True)
class Kind:
    """What an argument must be: `low <= measure(*components) <= high`, else it is mended or refused."""

    shape: tuple[int, ...]
    measure: Callable[..., Component]
    low: float
    high: float
    demand: str  # ends the sentence "<name> ...", and says what to do
    mend: Callable[[Array], Array] | None = None  # brings entries of extreme size into range, rows (n, k)

    def holds(self, components: list[Component]) -> Component:
        """Whether it is so: a bool, or one for each rotation (False where not a number)."""
        measure = self.measure(*components)
        return (self.low <= measure) & (measure <= self.high)


@dataclass(frozen=True)
class Argument:
    """An argument of a public function: its name, what it must be, its value."""

    name: str
    kind: Kind
    value: Array

    @property
    def batch(self) -> tuple[int, ...]:
        """The leading axes."""
        return self.value.shape[: self.value.ndim - len(self.kind.shape)]


def argument(name: str, kind: Kind, value: ArrayLike) -> Argument:
    """The value as floats, its shape checked; ValueError names the argument."""
    numbers = np.asarray(value, dtype=np.float64)
    rank = len(kind.shape)
    if numbers.shape[numbers.ndim - rank :] != kind.shape:
        wanted = ", ".join(["...", *map(str, kind.shape)])
        raise ValueError(f"{name} has shape {numbers.shape}, but must have shape ({wanted})")
    return Argument(name, kind, numbers)


def evaluate(formula: Formula, arguments: list[Argument], shape: tuple[int, ...]) -> Array:
    """`formula` of the arguments' components, for every rotation in the batch; results of `shape` each."""
    if not any(a.batch for a in arguments):
        components = [a.value.ravel().tolist() for a in arguments]
        if all(a.kind.holds(c) for a, c in zip(arguments, components, strict=True)):
            return np.array(formula(FLOATS, *sum(components, []))).reshape(shape)
    batch = np.broadcast_shapes(*(a.batch for a in arguments))
    count = math.prod(batch)
    tables = [
        np.broadcast_to(a.value, batch + a.kind.shape).reshape(count, math.prod(a.kind.shape))
        for a in arguments
    ]
    results = np.empty((count, math.prod(shape)))
    with np.errstate(all="ignore"):  # what is not a number is refused by name; underflow is harmless
        for start in range(0, count, BLOCK):
            block = slice(start, start + BLOCK)
            columns = [_columns(a, table[block]) for a, table in zip(arguments, tables, strict=True)]
            for column, values in enumerate(formula(ARRAYS, *sum(columns, []))):
                results[block, column] = values
    return results.reshape(batch + shape)


def _columns(a: Argument, table: Array) -> list[Component]:
    """The columns of a block, contiguous; mended where the argument's kind allows it, else checked."""
    columns = list(np.ascontiguousarray(table.T))
    if not a.kind.holds(columns).all() and a.kind.mend is not None:
        columns = list(np.ascontiguousarray(a.kind.mend(table).T))
    holds = a.kind.holds(columns)
    if not holds.all():
        wrong = table[np.argmin(holds)]
        raise ValueError(f"{a.name} {a.kind.demand}; one is {wrong.reshape(a.kind.shape).tolist()}")
    return columns
