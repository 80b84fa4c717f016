"""What a function is given: each of these raises a ValueError that names the argument it refuses."""

from collections.abc import Collection, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tam570.values import Numbers

LEAST, MOST = 1e-100, 1e100  # of a number in SI units: its square and its cube are numbers
SYMMETRIC = 1e-9  # of the largest element: rounding of a matrix that was computed, by a rotation say


def positive(**arguments: float) -> None:
    """Refuses what is not a number above 0, as in positive(mass=mass)."""
    for name, value in arguments.items():
        if not (_is_symbol(value) or _is_real(value) and LEAST <= value <= MOST):
            raise ValueError(f"{name}: must be a positive number from {LEAST:g} to {MOST:g}, got {value!r}")


def nonnegative(**arguments: float) -> None:
    """Refuses what is not a number of 0 or more."""
    for name, value in arguments.items():
        if not (_is_symbol(value) or _is_real(value) and 0.0 <= value <= MOST):
            raise ValueError(f"{name}: must be a number from 0 to {MOST:g}, got {value!r}")


def finite(**arguments: float) -> None:
    """Refuses what is not a finite number."""
    for name, value in arguments.items():
        if not (_is_symbol(value) or _is_real(value) and -MOST <= value <= MOST):
            raise ValueError(f"{name}: must be a number from {-MOST:g} to {MOST:g}, got {value!r}")


def whole_number(least: int, **arguments: int) -> None:
    """Refuses what is not a whole number of `least` or more."""
    for name, value in arguments.items():
        if isinstance(value, bool) or not isinstance(value, int | np.integer) or value < least:
            raise ValueError(f"{name}: must be a whole number of {least} or more, got {value!r}")


def one_of(choices: Collection[str], **arguments: object) -> None:
    """Refuses what is not among the choices."""
    for name, value in arguments.items():
        if not (isinstance(value, str) and value in choices):
            raise ValueError(f"{name}: must be one of {', '.join(map(repr, choices))}, got {value!r}")


def sequence(count: int, **arguments: Sequence[float]) -> None:
    """Refuses what is not a flat list of `count`; the numbers themselves may be symbols."""
    for name, value in arguments.items():
        if len(_shape(name, value)) != 1 or len(value) != count:
            raise ValueError(f"{name}: must be {count} numbers, got {value!r}")


def array(shape: tuple[int | None, ...] | None, **arguments: ArrayLike) -> NDArray[np.float64]:
    """Return the one array that is named, of finite floats and this shape; None stands for any shape, or length."""
    ((name, value),) = arguments.items()
    actual = _shape(name, value)
    shape = (None,) * len(actual) if shape is None else shape
    if len(actual) != len(shape) or any(n is not None and m != n for m, n in zip(actual, shape, strict=True)):
        wanted = ", ".join("n" if n is None else str(n) for n in shape)
        raise ValueError(f"{name}: must have the shape ({wanted}{',' * (len(shape) == 1)}), got {actual}")
    values = _floats(name, value)
    if values.dtype != object and not (np.abs(values) <= MOST).all():
        raise ValueError(f"{name}: must be numbers from {-MOST:g} to {MOST:g}, got {values}")
    return values


def like(example: Numbers, **arguments: Numbers) -> None:
    """Refuses what is not a number, or numbers in as many rows and columns, as the example is."""
    for name, value in arguments.items():
        if np.ndim(example):
            array((None,) * np.ndim(example), **{name: value})
        elif not isinstance(example, str):
            finite(**{name: value})


def symmetric(shape: tuple[int | None, int | None], **arguments: ArrayLike) -> NDArray[np.float64]:
    """Return the one square matrix that is named, of this shape, and symmetric but for rounding."""
    matrix = array(shape, **arguments)
    n, m = matrix.shape
    if n != m or n == 0 or np.abs(matrix - matrix.T).max() > SYMMETRIC * np.abs(matrix).max():
        raise ValueError(f"{next(iter(arguments))}: must be square and symmetric, got {matrix.tolist()}")
    return (matrix + matrix.T) / 2


def positives(count: int | None = None, **arguments: Sequence[float]) -> tuple[float, ...]:
    """Return the one sequence that is named, of `count` positive floats."""
    ((name, value),) = arguments.items()
    values = numbers(count, **arguments)
    if values.dtype != object and not (values.size and (values >= LEAST).all()):
        raise ValueError(f"{name}: must be positive numbers of {LEAST:g} or more, got {value!r}")
    return tuple(values.tolist())


def numbers(count: int | None = None, **arguments: ArrayLike) -> NDArray[np.float64]:
    """Return the one flat array that is named, of `count` finite floats."""
    return array((count,), **arguments)


def _is_symbol(value: object) -> bool:
    """Return whether it stands for a number that a trace does not know yet."""
    return hasattr(value, "tape")


def _is_real(value: object) -> bool:
    return isinstance(value, float | int | np.floating | np.integer) and not isinstance(value, bool)


def _shape(name: str, value: ArrayLike) -> tuple[int, ...]:
    try:
        return np.shape(value)
    except ValueError:  # rows of different lengths
        raise ValueError(f"{name}: must be numbers in equal rows, got {value!r}") from None


def _floats(name: str, value: ArrayLike) -> NDArray[np.float64]:
    if np.iscomplexobj(value):
        raise ValueError(f"{name}: must be real, got {value!r}")
    try:
        return np.array(value, dtype=np.float64)
    except (TypeError, ValueError):
        if any(map(_is_symbol, np.ravel(value))):
            return np.array(value)
        raise ValueError(f"{name}: must be numbers, got {value!r}") from None


def divisors(values: NDArray[np.generic]) -> None:
    """Raise ZeroDivisionError where a number is zero, as Python does and NumPy does not; symbols pass.

    In the function itself, a use of `dtype` would end its trace.
    """
    if values.dtype != object and not values.all():
        raise ZeroDivisionError
