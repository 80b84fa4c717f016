"""Evaluate one formula on floats for a single rotation, or on arrays for a batch, so that both are fast.

A formula is a straight-line function `formula(f, *components)` of numbers. `f` has the elementary functions: those of
`math` for one rotation (no array overhead), those of NumPy for a block of rotations, component by component. Its first
result is a measure of its input that costs almost nothing. Only if the measure leaves its range are the arguments
checked one by one.
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
Stacked = Callable[[list[Array], Array, Array], Array]  # (arguments (k, n), workspace, results (n, m)) -> measure (n,)

BLOCK = 4096  # rotations evaluated together, whose components fit in the second-level cache
STACK = 8400  # for stacked formulas: up to 4096 numbers, NumPy computes products with one row one at a time
ROWS = 16  # of the workspace


@dataclass(frozen=True)
class Functions:
    """The elementary functions that a formula may use."""

    sin: Callable[..., Component]
    cos: Callable[..., Component]
    tan: Callable[..., Component]
    sqrt: Callable[..., Component]
    atan2: Callable[..., Component]
    hypot: Callable[..., Component]
    norm: Callable[..., Component]
    where: Callable[..., Component]


def _either(condition: bool, if_true: float, if_false: float) -> float:
    return if_true if condition else if_false


def _norm(x: Array, y: Array, z: Array) -> Array:
    """Return the length of a vector; unlike in the root of a sum of squares, no square underflows."""
    return np.asarray(np.hypot(np.hypot(x, y), z))


FLOATS = Functions(math.sin, math.cos, math.tan, math.sqrt, math.atan2, math.hypot, math.hypot, _either)
ARRAYS = Functions(np.sin, np.cos, np.tan, np.sqrt, np.arctan2, np.hypot, _norm, np.where)


@dataclass(frozen=True)
class Requirement:
    """A condition on an argument. A measure in the range of the first one means that all arguments meet theirs."""

    shape: tuple[int, ...]
    holds: Callable[[Array], NDArray[np.bool_]]  # of rows (n, k), one for each rotation: which meet it
    demand: str  # ends the sentence "<name> ...", and says what to do
    mend: Callable[[Array], Array] = lambda rows: rows  # scales unusual lengths into range
    measures: tuple[float, float] = (0.0, 0.0)  # range of the measure, in which rows need no check


Argument = tuple[str, Requirement, Array]  # name, requirement, values


def evaluate(
    formula: Formula,
    shape: tuple[int, ...],
    *arguments: tuple[str, Requirement, ArrayLike],
    stacked: Stacked | None = None,
) -> Array:
    """Return `formula` of the arguments' components, for every rotation in the batch; results of `shape` each.

    arguments : name, requirement and value of each
    stacked   : the same formula for batches, if it is also written for stacks of components
    """
    floats = [(name, requirement, np.asarray(value, dtype=np.float64)) for name, requirement, value in arguments]
    single = _evaluate_single(formula, shape, floats)
    if single is not None:
        return single
    return _evaluate_batch(stacked or _by_component(formula), STACK if stacked else BLOCK, shape, floats)


def _evaluate_single(formula: Formula, shape: tuple[int, ...], arguments: list[Argument]) -> Array | None:
    """Evaluate on floats; return None for more than one rotation, or for input that needs a check."""
    numbers: list[float] = []
    for _, requirement, value in arguments:
        if value.shape != requirement.shape:
            return None
        numbers += value.ravel().tolist()
    try:
        measure, *results = formula(FLOATS, *numbers)
    except (ValueError, ArithmeticError):  # math raises where NumPy returns NaN
        return None
    least, greatest = arguments[0][1].measures
    return np.array(results).reshape(shape) if least <= measure <= greatest else None


def _by_component(formula: Formula) -> Stacked:
    """Return a formula for stacks that evaluates them component by component."""

    def stacked(tables: list[Array], _: Array, results: Array) -> Array:
        components = (row for table in tables for row in np.ascontiguousarray(table))
        measure, *columns = formula(ARRAYS, *components)
        results[...] = np.concatenate(columns).reshape(len(columns), -1).T
        return np.asarray(measure)

    return stacked


def _evaluate_batch(formula: Stacked, block: int, shape: tuple[int, ...], arguments: list[Argument]) -> Array:
    batch, tables = _tables(arguments)
    count = math.prod(batch)
    results, workspace = np.empty((count, math.prod(shape))), _workspace(min(count, block), aligned=count >= block)
    least, greatest = arguments[0][1].measures
    with np.errstate(all="ignore"):  # NaN is refused below, with the argument's name; underflow is harmless
        for start in range(0, count, block):
            rows, part = [table[start : start + block] for table in tables], results[start : start + block]
            part_workspace = workspace if len(part) == block else workspace[:, : len(part)]
            measure = formula([table.T for table in rows], part_workspace, part)
            # argmin and argmax give the index of a NaN, if any
            if not (measure[measure.argmin()] >= least and measure[measure.argmax()] <= greatest):
                mended = [_mended(*argument[:2], table).T for argument, table in zip(arguments, rows, strict=True)]
                formula(mended, part_workspace, part)
    return results.reshape(batch + shape)


def _workspace(columns: int, *, aligned: bool) -> Array:
    """Return the workspace; if `aligned`, no SIMD vector in it crosses a cache line, which pays for large blocks."""
    if not aligned:
        return np.empty((ROWS, columns))
    numbers = np.empty(ROWS * columns + 8)
    first = -numbers.__array_interface__["data"][0] // 8 % 8
    return numbers[first : first + ROWS * columns].reshape(ROWS, columns)


def _tables(arguments: list[Argument]) -> tuple[tuple[int, ...], list[Array]]:
    """Return the batch's shape, and each argument as rows (n, k)."""
    batches = [_batch(*argument) for argument in arguments]
    values = [value for _, _, value in arguments]
    batch = batches[0]
    if batches.count(batch) < len(batches):
        try:
            batch = np.broadcast_shapes(*batches)
        except ValueError as error:
            names = " and ".join(name for name, _, _ in arguments)
            raise ValueError(f"{names} do not broadcast: {error}") from None
        values = [np.broadcast_to(value, batch + requirement.shape) for _, requirement, value in arguments]
    count = math.prod(batch)
    return batch, [v.reshape(count, math.prod(r.shape)) for v, (_, r, _) in zip(values, arguments, strict=True)]


def _batch(name: str, requirement: Requirement, value: Array) -> tuple[int, ...]:
    """Return the leading axes of an argument. Raise ValueError if the others are wrong."""
    rank = value.ndim - len(requirement.shape)
    if value.shape[rank:] != requirement.shape or rank < 0:
        wanted = ", ".join(["...", *map(str, requirement.shape)])
        raise ValueError(f"{name} has shape {value.shape}, but must have shape ({wanted})")
    return value.shape[:rank]


def _mended(name: str, requirement: Requirement, rows: Array) -> Array:
    """Return the rows of an argument, with lengths in range. Raise ValueError for a row that is not as required."""
    holds = requirement.holds(rows)
    if not holds.all():
        wrong = rows[np.argmin(holds)].reshape(requirement.shape)
        raise ValueError(f"{name} {requirement.demand}; one is {wrong.tolist()}")
    return requirement.mend(rows)
