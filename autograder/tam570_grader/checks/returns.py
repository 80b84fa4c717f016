"""What a student's function must return: `Assignment.returns` maps the names of functions to these specifications.

    returns={"rotation_matrix": array(3, 3), "simulate": rows(4), "energy_balance": group(number, number, number),
             "lagrangian": formula("theta", "omega", "m", "l", "g"), "plot_tip_path": drawing}

`number.described("the energy", "J", size)` names a result in messages, with its unit and the scale of its error;
`rows(4, columns=MOTION, rates=RATES)` does so for the columns of a motion, and names the function of its rates.

A result of another form ends the check with a message that says what came instead. Lists, tuples and NumPy scalars
are accepted if `numpy.asarray` turns them into the shape.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from typing import Self

import numpy as np

from tam570.forms import Form, WrongForm, conform, fits, is_sequence
from tam570.values import Numbers
from tam570_grader.checks.case import Case
from tam570_grader.checks.expect import Failed

Scale = Callable[[Case, Numbers], Numbers]  # scale(case, expected result)


@dataclass(frozen=True)
class Description:
    """How messages describe a result."""

    quantity: str = "the result"
    unit: str = ""
    scale: Scale | None = None  # default: the largest number


@dataclass(frozen=True)
class Described:
    """Base class of specifications with a description."""

    description: Description = field(default=Description(), compare=False, kw_only=True)

    def described(self, quantity: str, unit: str = "", scale: Scale | None = None) -> Self:
        """Return a copy with a description of its result."""
        return replace(self, description=Description(quantity, unit, scale))


@dataclass(frozen=True)
class Array(Described):
    """A float64 array; in its shape, None is any length but zero, and "n" the length of the first argument."""

    shape: tuple[int | str | None, ...]
    infinite: bool = False  # whether math.inf is allowed
    columns: Sequence[Numbers] = field(default=(), compare=False)  # each a `Column`
    rates: Numbers = field(default=None, compare=False)  # the `OwnRates` of a motion


@dataclass(frozen=True)
class Group:
    """A tuple of results, which together may have the columns of a motion."""

    members: tuple["Array | Group", ...]
    columns: Sequence[Numbers] = field(default=(), compare=False)
    rates: Numbers = field(default=None, compare=False)

    @property
    def description(self) -> list[Numbers]:
        return [member.description for member in self.members]


@dataclass(frozen=True)
class Formula(Described):
    """A SymPy expression in these symbols; `student.f.at([{"theta": .3, ...}, ...])` gives its values."""

    symbols: tuple[str, ...]


@dataclass(frozen=True)
class Line:
    """A line or scatter of a drawing: its points `(n, 2)`, its label, and how much of it can be seen."""

    points: np.ndarray
    label: str
    scatter: bool
    shows: float = 1.0  # share of the points that leave ink on the paper
    share_within: float = 1.0  # share of the points within the limits of the axes
    extent: float = 1.0  # on paper, relative to the figure


@dataclass(frozen=True)
class Drawing:
    """What a plot function drew on its Axes; in `returns`, the instance `drawing` is the specification."""

    lines: tuple[Line, ...] = ()
    xlabel: str = ""
    ylabel: str = ""
    labels_show: tuple[bool, bool] = (True, True)
    scales: tuple[float, float] = (1.0, 1.0)  # lengths on paper of a unit of x, to the right, and of y, upwards
    bent: float = 0.0  # deviation of the axes from linear ones, relative to their length


@dataclass(frozen=True)
class Arrow:
    """A force of a free body diagram: its point, and a vector along it; None if no component is known."""

    point: np.ndarray
    direction: np.ndarray | None


@dataclass(frozen=True)
class FreeBodyDiagram:
    """A list of pairs (point, direction) in `dimension` dimensions; the result is a tuple of `Arrow`."""

    dimension: int


number = Array(())
drawing = Drawing()
free_body_diagram = FreeBodyDiagram
ReturnSpec = Array | Group | Formula | Drawing | FreeBodyDiagram


def array(*shape: int | str | None, infinite: bool = False, columns: Sequence[Numbers] = ()) -> Array:
    """Describe an array of this shape."""
    return Array(shape, infinite, columns)


def rows(*shape: int, columns: Sequence[Numbers] = (), rates: Numbers = None) -> Array:
    """Describe an array with one row for each element of the first argument: `(n, *shape)`."""
    return Array(("n", *shape), columns=columns, rates=rates)


def group(*members: Array | Group, columns: Sequence[Numbers] = (), rates: Numbers = None) -> Group:
    """Describe several results of one function."""
    return Group(members, columns, rates)


def formula(*symbols: str) -> Formula:
    """Describe a SymPy expression in these symbols."""
    return Formula(symbols)


def form(returns: ReturnSpec) -> Form:
    """Return a specification as plain data."""
    if isinstance(returns, Group):
        return {"group": [form(member) for member in returns.members]}
    if isinstance(returns, Formula):
        return {"formula": list(returns.symbols)}
    if isinstance(returns, Drawing):
        return {"drawing": True}
    if isinstance(returns, FreeBodyDiagram):
        return {"diagram": returns.dimension}
    return {"array": list(returns.shape), **({"infinite": True} if returns.infinite else {})}


def result(returns: ReturnSpec, value: object, name: str, call: Case) -> Numbers:
    """Return the student's result as `conform` does, a diagram's forces as arrows; raise Failed for a wrong form."""
    try:
        numbers = conform(form(returns), value, name, call.args)
    except WrongForm as wrong:
        raise Failed(str(wrong), hint=wrong.hint, actual=wrong.actual) from None
    return tuple(Arrow(*force) for force in numbers) if isinstance(returns, FreeBodyDiagram) else numbers


def results_alike(returns: ReturnSpec, values: Sequence[Numbers]) -> list[Numbers] | None:
    """Return the results of several calls, each as by `result`; None if one may have a wrong form."""
    if isinstance(returns, Group):
        if not all(is_sequence(value) and len(value) == len(returns.members) for value in values):
            return None
        members = [results_alike(*pair) for pair in zip(returns.members, zip(*values, strict=True), strict=False)]
        return None if not values or any(member is None for member in members) else list(zip(*members, strict=True))
    if not values or not isinstance(returns, Array) or "n" in returns.shape:
        return None
    try:
        numbers = np.array(values)
    except ValueError:  # they differ in shape
        return None
    if numbers.dtype.kind not in "fiub" or not fits(numbers.shape[1:], returns.shape):
        return None
    if np.isnan(numbers).any() if returns.infinite else not np.isfinite(numbers).all():
        return None
    return list(numbers.astype(np.float64)) if returns.shape else numbers.astype(np.float64).tolist()
