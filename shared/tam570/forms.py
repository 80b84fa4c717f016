"""Check that a result has the form that the assignment asks for, for `check`, `show` and the grader.

A form is plain data of `contract.json`: {"array": [3, 3]}; {"array": ["n", 2]}, with a row for each element of the
first argument; {"array": [null], "infinite": true}, of any length but zero, in which infinity is allowed;
{"group": [...]} of forms; {"formula": ["theta", ...]}; {"diagram": 2}, with its dimension; or {"drawing": true}.
"""

from collections.abc import Sequence
from typing import TypeAlias

import numpy as np

from tam570.formulas import REMEDIES, form_of, unknown_symbols
from tam570.values import Json, Numbers

Form: TypeAlias = Json
Sizes = Sequence[int | str | None]

MOST_FORCES = 8  # in a diagram; the largest correct one has five
LONGEST_TOLD = 2000  # largest size that a message states; no check asks for more rows
LONGEST = 100_000  # largest length where the form leaves it open
MOST_DIMENSIONS = 3  # of a shape that a message states
NO_NUMBERS = {"c": "complex numbers", "U": "an array of strings"}  # by dtype.kind


class WrongForm(Exception):
    """A result of another form than the contract's, with a message, a hint, and the returned numbers, if any."""

    def __init__(self, message: str, hint: str = "", actual: Numbers = None) -> None:
        super().__init__(message)
        self.hint, self.actual = hint, actual

    @property
    def sentences(self) -> str:
        return f"{self}. {self.hint}".rstrip()


def conform(form: Form, value: Numbers, name: str, arguments: Sequence[Numbers]) -> Numbers:
    """Convert a result to its form, from anything that `numpy.asarray` converts to numbers of the right shape.

    Parameters
    ----------
    form : as in the module's docstring
    value : result of the function `name`
    arguments : positional arguments of the call

    Returns
    -------
    A float, a float64 array, or a tuple of these; for a diagram, a list of pairs (point, direction), where the
    direction is None if all its components are; formulas and drawings unchanged.

    Raises
    ------
    WrongForm
    """
    if "group" in form:
        return _members(form["group"], value, name, arguments)
    if "diagram" in form:
        return _forces(form["diagram"], value, name)
    if "array" in form:
        return _array(form, value, name, arguments)
    if "formula" in form:
        _must_be_formula(value, form["formula"], name)
    return value


def _members(forms: Sequence[Form], value: Numbers, name: str, arguments: Sequence[Numbers]) -> tuple[Numbers, ...]:
    if not is_sequence(value) or len(value) != len(forms):
        came = f"{_size(len(value))} results" if is_sequence(value) else _kind(value)
        message = f"{name} returned {came}, not a tuple of {len(forms)} results, as in `return a, b`"
        raise WrongForm(message, _remedy(value))
    return tuple(
        conform(form, member, f"{name} (result {index})", arguments)
        for index, (form, member) in enumerate(zip(forms, value, strict=True), start=1)
    )


MISSING = "Rows are missing: did the integration stop early, or are these rows at times of your own?"
EXTRA = "Return one row for each entry of the first argument: are these rows at times of your own?"


def _array(form: Form, value: Numbers, name: str, arguments: Sequence[Numbers]) -> Numbers:
    numbers = _numbers(value, name)
    shape = tuple(len(arguments[0]) if size == "n" else size for size in form["array"])
    if not fits(numbers.shape, shape):
        message = f"{name} returned {_shaped(numbers.shape)}, not {_shaped(shape)}"
        actual = numbers if numbers.size <= LONGEST_TOLD else None  # no check asks for more
        rows = form["array"][:1] == ["n"] and numbers.shape[1:] == shape[1:]
        more = numbers.shape[0] - shape[0] if rows else 0  # one row may be a slip; an early stop loses several
        raise WrongForm(message, EXTRA if more > 1 else MISSING if more < -1 else "", actual)
    if np.isnan(numbers).any() or (not form.get("infinite") and np.isinf(numbers).any()):
        raise WrongForm(f"{name} returned NaN or infinity", actual=numbers)
    return numbers if numbers.ndim else float(numbers)


def _forces(dimension: int, value: Numbers, name: str) -> list[tuple[Numbers, Numbers]]:
    """Return the pairs (point, direction) of a diagram's arrows, without arrows of length zero."""
    if not is_sequence(value):
        raise WrongForm(f"{name} returned {_kind(value)}, not a list of pairs (point, direction)", _remedy(value))
    if len(value) > MOST_FORCES:
        raise WrongForm(f"{name} returned more than {MOST_FORCES} forces")
    forces = []
    for index, pair in enumerate(value, start=1):
        force = f"{name} (force {index})"
        if not is_sequence(pair) or len(pair) != 2:
            raise WrongForm(f"{force} is not a pair (point, direction)")
        point, direction = pair
        unknown = direction is None or (is_sequence(direction) and all(component is None for component in direction))
        forces.append((_vector(dimension, point, force), None if unknown else _vector(dimension, direction, force)))
    return [(point, direction) for point, direction in forces if direction is None or direction.any()]


def _vector(dimension: int, value: Numbers, name: str) -> Numbers:
    """Return a vector of the diagram's dimension; in a plane, drop a third component of zero."""
    numbers = _numbers(value, name)
    if dimension == 2 and numbers.shape == (3,) and numbers[2] == 0:
        numbers = numbers[:2]
    if numbers.shape != (dimension,):
        shapes = _shaped(numbers.shape), _shaped((dimension,))
        raise WrongForm(f"{name} has {shapes[0]} as its point or direction, not {shapes[1]}")
    if not np.isfinite(numbers).all():
        raise WrongForm(f"{name} holds NaN or infinity", actual=numbers)
    return numbers


def _numbers(value: Numbers, name: str) -> Numbers:
    """Convert a value, or SymPy numbers, to float64; refuse complex numbers, strings and ragged lists."""
    try:
        numbers = np.asarray(value)
    except ValueError:
        raise WrongForm(f"{name} returned a list whose rows differ in length") from None
    try:
        if numbers.dtype.kind == "O":
            numbers = np.reshape([float(number) for number in numbers.ravel()], numbers.shape)
        if numbers.dtype.kind not in "fiub":
            raise TypeError
    except (TypeError, ValueError, ArithmeticError):
        came = (not isinstance(value, str) and NO_NUMBERS.get(numbers.dtype.kind)) or _kind(value)
        raise WrongForm(f"{name} returned {came}, not real numbers", _remedy(value)) from None
    return numbers.astype(np.float64)


def _must_be_formula(value: Numbers, symbols: Sequence[str], name: str) -> None:
    import sympy

    if form := form_of(value):
        raise WrongForm(f"{name} returned {form} in place of a SymPy expression", REMEDIES.get(form, ""))
    if names := unknown_symbols(sympy.sympify(value).doit(), symbols, [dict.fromkeys(symbols, 0.7)]):
        message = f"{name} does not return a SymPy expression in {', '.join(symbols)} alone"
        raise WrongForm(message, f"It has {', '.join(names)} in it.")


def _kind(value: Numbers) -> str:
    """Describe a value without its numbers, which in the grader could reveal hidden inputs."""
    if isinstance(value, bool | int | float) or getattr(value, "shape", None) == ():
        return "a single number"
    if is_sequence(value):
        return "a list that holds something other than numbers"
    text = getattr(value, "type_name", "") or " ".join(repr(value).split())
    return text if len(text) <= 60 else f"{text[:57]}..."


def _remedy(value: Numbers) -> str:
    return REMEDIES["None"] if value is None else ""


def is_sequence(value: Numbers) -> bool:
    """Return whether a value is a list, a tuple or an array with at least one dimension."""
    return isinstance(value, list | tuple) or (isinstance(value, np.ndarray) and value.ndim > 0)


def fits(shape: Sequence[int], wanted: Sizes) -> bool:
    """Return whether a shape is the wanted one, in which None allows any length from 1 to LONGEST."""
    sizes = zip(shape, wanted, strict=False)
    return len(shape) == len(wanted) and all(
        have == want if want is not None else 0 < have <= LONGEST for have, want in sizes
    )


def _shaped(shape: Sizes) -> str:
    if not shape:
        return "a single number"
    if 0 in shape:
        return "an empty array"  # its other sizes could reveal hidden inputs
    if len(shape) > MOST_DIMENSIONS:
        return f"an array of more than {MOST_DIMENSIONS} dimensions"
    sizes = ", ".join("k" if size is None else _size(size) for size in shape)
    return f"an array of shape ({sizes}{',' if len(shape) == 1 else ''})"


def _size(size: int | str) -> str:
    """Return a length as text, or "many" for a long one, whose digits could reveal hidden inputs."""
    return "many" if isinstance(size, int) and size > LONGEST_TOLD else str(size)
