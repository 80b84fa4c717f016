"""What a student's function returns, as the contract promises it: `Assignment.returns` maps names to these.

    returns={"rotation_matrix": array(3, 3), "simulate": rows(4), "energy_balance": group(number, number, number),
             "lagrangian": formula("theta", "omega", "m", "l", "g"), "plot_tip_path": drawing}

`number.described("the energy", "J", size)` names a result in messages, its unit and what its error is relative to;
`rows(4, columns=MOTION)` does so for columns.

A result that is not of this form ends the check with a message that says what came instead. What is
accepted is what `numpy.asarray` turns into that shape: lists, tuples and NumPy scalars too.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from typing import Self, TypeGuard

import numpy as np
from numpy.typing import NDArray

from tam570.values import Numbers
from tam570_grader.checks.case import Case
from tam570_grader.checks.expect import Failed
from tam570_grader.protocol.wire import Foreign

Sizes = tuple[int | str | None, ...]
Scale = Callable[[Case, Numbers], Numbers]  # scale(case, right result) -> what an error is relative to


@dataclass(frozen=True)
class Description:
    """What messages call a result."""

    quantity: str = "the result"
    unit: str = ""
    scale: Scale | None = None  # default: the largest number


@dataclass(frozen=True)
class Described:
    """A result with what messages call it."""

    description: Description = field(default=Description(), compare=False, kw_only=True)

    def described(self, quantity: str, unit: str = "", scale: Scale | None = None) -> Self:
        """Return the same promise, with what messages call its result."""
        return replace(self, description=Description(quantity, unit, scale))


@dataclass(frozen=True)
class Array(Described):
    """A float64 array; None stands for any length but zero, and "n" for as many as the first argument has."""

    shape: tuple[int | str | None, ...]
    infinite: bool = False  # may be math.inf
    columns: Sequence[Numbers] = field(default=(), compare=False)  # each a `Column`


@dataclass(frozen=True)
class Group:
    """A tuple of results."""

    members: tuple["Array | Group", ...]

    @property
    def description(self) -> list[Numbers]:
        return [member.description for member in self.members]


@dataclass(frozen=True)
class Formula(Described):
    """A SymPy expression in these symbols; `student.f.at([{"theta": .3, ...}, ...])` gives its values."""

    symbols: tuple[str, ...]


@dataclass(frozen=True)
class Line:
    """One line or scatter of a drawing: its points `(n, 2)`, its label, and what of it can be seen."""

    points: np.ndarray
    label: str
    scatter: bool
    shows: float = 1.0  # share of the points that leave ink on the paper
    tolerance: float = 1.0  # share of them within the limits of the axes
    extent: float = 1.0  # on paper, as a share of the figure


@dataclass(frozen=True)
class Drawing:
    """What a plot function drew on its Axes; in `returns`, the instance `drawing` promises one."""

    lines: tuple[Line, ...] = ()
    xlabel: str = ""
    ylabel: str = ""
    labels_show: tuple[bool, bool] = (True, True)
    scales: tuple[float, float] = (1.0, 1.0)  # lengths on paper of a unit of x to the right and of y up
    bent: float = 0.0  # how unevenly units follow one another, as a share of the axes


@dataclass(frozen=True)
class Arrow:
    """A force of a free body diagram: where it acts, and along which vector; None where no component is known."""

    point: np.ndarray
    direction: np.ndarray | None


@dataclass(frozen=True)
class FreeBodyDiagram:
    """A list of pairs (point, direction) in so many dimensions; the result is a tuple of `Arrow`."""

    dimension: int


MOST_ARROWS = 8  # of a diagram; the largest right one has five
LONGEST_TOLD = 2000  # elements of a result: no check asks for more rows
LONGEST = 100_000  # rows of a result whose length is the student's choice
MOST_DIMENSIONS = 3  # of a shape that is told

number = Array(())
drawing = Drawing()
free_body_diagram = FreeBodyDiagram
ReturnSpec = Array | Group | Formula | Drawing | FreeBodyDiagram


def array(*shape: int | str | None, infinite: bool = False, columns: Sequence[Numbers] = ()) -> Array:
    """Describe an array of this shape."""
    return Array(shape, infinite, columns)


def rows(*shape: int, columns: Sequence[Numbers] = ()) -> Array:
    """One row for each element of the first argument: `(n, *shape)`."""
    return Array(("n", *shape), columns=columns)


def group(*members: Array | Group) -> Group:
    """Describe several results of one function."""
    return Group(members)


def formula(*symbols: str) -> Formula:
    """Describe an expression of SymPy in these symbols."""
    return Formula(symbols)


def result(returns: Array | Group | FreeBodyDiagram, value: object, name: str, call: Case) -> Numbers:
    """Return the student's result in the promised form.

    A float, an array, or a tuple of these or of arrows; else Failed.
    """
    if isinstance(returns, FreeBodyDiagram):
        return _arrows(returns, value, name)
    if isinstance(returns, Group):
        return _members(returns, value, name, call)
    numbers = _array(value, name)
    shape = tuple(len(call.args[0]) if size == "n" else size for size in returns.shape)
    if not _fits(numbers.shape, shape):
        message = f"{name} returned {_shaped(numbers.shape)}, not {_shaped(shape)}"
        actual = numbers if numbers.size <= LONGEST_TOLD else None  # of a size that no check asked for
        raise Failed(message, hint=_cut_short(returns, numbers.shape, shape), actual=actual)
    if not np.isfinite(numbers).all() and (not returns.infinite or np.isnan(numbers).any()):
        raise Failed(f"{name} returned NaN or infinity", actual=numbers)
    return numbers if numbers.ndim else float(numbers)


def results_alike(returns: ReturnSpec, values: Sequence[Numbers]) -> list[Numbers] | None:
    """Return the results of several calls, as `result` makes each, where all are as promised.

    None where one may not be.
    """
    if isinstance(returns, Group):
        if not all(_is_sequence(value) and len(value) == len(returns.members) for value in values):
            return None
        members = [results_alike(*pair) for pair in zip(returns.members, zip(*values, strict=True), strict=False)]
        return None if not values or any(member is None for member in members) else list(zip(*members, strict=True))
    if not values or not isinstance(returns, Array) or "n" in returns.shape:
        return None
    try:
        numbers = np.array(values)
    except ValueError:  # they differ in shape
        return None
    if numbers.dtype.kind not in "fiub" or not _fits(numbers.shape[1:], returns.shape):
        return None
    if np.isnan(numbers).any() if returns.infinite else not np.isfinite(numbers).all():
        return None
    return list(numbers.astype(np.float64)) if returns.shape else numbers.astype(np.float64).tolist()


def _members(returns: Group, value: object, name: str, call: Case) -> tuple[Numbers, ...]:
    if not _is_sequence(value) or len(value) != len(returns.members):
        came = f"{_size(len(value))} results" if _is_sequence(value) else _kind(value)
        raise Failed(f"{name} returned {came}, not a tuple of {len(returns.members)} results")
    return tuple(
        result(member, item, f"{name} (result {index})", call)
        for index, (member, item) in enumerate(zip(returns.members, value, strict=True), start=1)
    )


def _is_sequence(value: object) -> TypeGuard[list[Numbers] | NDArray[np.generic]]:
    return isinstance(value, list) or (isinstance(value, np.ndarray) and value.ndim > 0)


def _arrows(returns: FreeBodyDiagram, value: object, name: str) -> tuple[Arrow, ...]:
    """Return the arrows of a diagram; one of length zero draws nothing."""
    if not _is_sequence(value):
        raise Failed(f"{name} returned {_kind(value)}, not a list of pairs (point, direction)")
    if len(value) > MOST_ARROWS:
        raise Failed(f"{name} returned more than {MOST_ARROWS} forces")
    arrows = [_arrow(returns, pair, f"{name} (force {index})") for index, pair in enumerate(value, start=1)]
    return tuple(arrow for arrow in arrows if arrow.direction is None or arrow.direction.any())


def _arrow(returns: FreeBodyDiagram, pair: object, name: str) -> Arrow:
    if not _is_sequence(pair) or len(pair) != 2:
        raise Failed(f"{name} is not a pair (point, direction)")
    point, direction = pair
    unknown = direction is None or (isinstance(direction, list) and all(component is None for component in direction))
    return Arrow(_vector(returns, point, name), None if unknown else _vector(returns, direction, name))


def _vector(returns: FreeBodyDiagram, value: object, name: str) -> np.ndarray:
    """Return a vector of the diagram's dimension; in a plane a third component of zero does no harm."""
    numbers = _array(value, name)
    if returns.dimension == 2 and numbers.shape == (3,) and numbers[2] == 0:
        numbers = numbers[:2]
    if numbers.shape != (returns.dimension,):
        shapes = _shaped(numbers.shape), _shaped((returns.dimension,))
        raise Failed(f"{name} has {shapes[0]} as its point or direction, not {shapes[1]}")
    if not np.isfinite(numbers).all():
        raise Failed(f"{name} holds NaN or infinity", actual=numbers)
    return numbers


def _array(value: object, name: str) -> np.ndarray:
    """Return the value as float64; complex numbers, objects, strings and ragged lists are none."""
    try:
        numbers = np.asarray(value)
    except ValueError:
        raise Failed(f"{name} returned a list whose rows differ in length") from None
    if numbers.dtype.kind not in "fiub":
        raise Failed(f"{name} returned {_kind(value)}, not real numbers")
    return numbers.astype(np.float64)


def _fits(shape: tuple[int, ...], wanted: Sizes) -> bool:
    sizes = zip(shape, wanted, strict=False)
    return len(shape) == len(wanted) and all(
        have == want if want is not None else 0 < have <= LONGEST for have, want in sizes
    )


def _cut_short(returns: Array, shape: tuple[int, ...], wanted: Sizes) -> str:
    """Return a row may be forgotten; where several are missing, an integrator gave up."""
    rows_missing = (
        returns.shape[:1] == ("n",)
        and shape[1:] == wanted[1:]
        and isinstance(wanted[0], int)
        and shape[0] < wanted[0] - 1
    )
    return "Rows are missing: did the integration stop early?" if rows_missing else ""


def _shaped(shape: Sizes) -> str:
    if not shape:
        return "a single number"
    if 0 in shape:
        return "an empty array"  # whose other sizes could be anything
    if len(shape) > MOST_DIMENSIONS:
        return f"an array of more than {MOST_DIMENSIONS} dimensions"
    sizes = ", ".join("k" if size is None else _size(size) for size in shape)
    return f"an array of shape ({sizes}{',' if len(shape) == 1 else ''})"


def _size(size: int | str) -> str:
    """Return a length in words: a long one could be an input, written out."""
    return "many" if isinstance(size, int) and size > LONGEST_TOLD else str(size)


def _kind(value: object) -> str:
    if isinstance(value, Foreign):
        return value.type_name
    if isinstance(value, np.ndarray) and value.dtype.kind == "c":
        return "complex numbers"
    if value is None:
        return "None"
    if isinstance(value, bool | int | float):
        return "a single number"
    return "a list that holds something other than numbers"
