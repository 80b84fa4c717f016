"""Checks of a function's arguments, each of which raises a ValueError that names the argument."""

from collections.abc import Collection, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tam570.values import Numbers

LEAST, MOST = 1e-100, 1e100  # numbers in SI units whose squares and cubes do not overflow or underflow
SYMMETRIC = 1e-9  # relative to the largest element: rounding, as of a rotated matrix


def positive(**arguments: float) -> None:
    """Raise ValueError unless each argument is a positive number or a symbol, as in positive(mass=mass)."""
    for name, value in arguments.items():
        if not (_is_symbol(value) or _is_real(value) and LEAST <= value <= MOST):
            raise ValueError(f"{name}: must be a positive number from {LEAST:g} to {MOST:g}, got {value!r}")


def nonnegative(**arguments: float) -> None:
    """Raise ValueError unless each argument is a number of 0 or more, or a symbol."""
    for name, value in arguments.items():
        if not (_is_symbol(value) or _is_real(value) and 0.0 <= value <= MOST):
            raise ValueError(f"{name}: must be a number from 0 to {MOST:g}, got {value!r}")


def finite(**arguments: float) -> None:
    """Raise ValueError unless each argument is a finite number or a symbol."""
    for name, value in arguments.items():
        if not (_is_symbol(value) or _is_real(value) and -MOST <= value <= MOST):
            raise ValueError(f"{name}: must be a number from {-MOST:g} to {MOST:g}, got {value!r}")


def whole_number(least: int, **arguments: int) -> None:
    """Raise ValueError unless each argument is an integer of `least` or more."""
    for name, value in arguments.items():
        if isinstance(value, bool) or not isinstance(value, int | np.integer) or value < least:
            raise ValueError(f"{name}: must be a whole number of {least} or more, got {value!r}")


def one_of(choices: Collection[str], **arguments: object) -> None:
    """Raise ValueError unless each argument is one of the choices."""
    for name, value in arguments.items():
        if not (isinstance(value, str) and value in choices):
            raise ValueError(f"{name}: must be one of {', '.join(map(repr, choices))}, got {value!r}")


def sequence(count: int, **arguments: Sequence[float]) -> None:
    """Raise ValueError unless each argument has `count` elements in one dimension; their values are not checked."""
    for name, value in arguments.items():
        if len(_shape(name, value)) != 1 or len(value) != count:
            raise ValueError(f"{name}: must be {count} numbers, got {value!r}")


def array(shape: tuple[int | None, ...] | None, **arguments: ArrayLike) -> NDArray[np.float64]:
    """Return the argument as an array of finite floats or symbols in this shape; None allows any shape or length."""
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
    """Raise ValueError unless each argument is finite, with the example's number of dimensions; a string allows any."""
    for name, value in arguments.items():
        if np.ndim(example):
            array((None,) * np.ndim(example), **{name: value})
        elif not isinstance(example, str):
            finite(**{name: value})


def symmetric(shape: tuple[int | None, int | None], **arguments: ArrayLike) -> NDArray[np.float64]:
    """Return the argument, a square matrix that must be symmetric up to rounding, in exactly symmetric form."""
    matrix = array(shape, **arguments)
    n, m = matrix.shape
    if n != m or n == 0 or np.abs(matrix - matrix.T).max() > SYMMETRIC * np.abs(matrix).max():
        raise ValueError(f"{next(iter(arguments))}: must be square and symmetric, got {matrix.tolist()}")
    return (matrix + matrix.T) / 2


def positives(count: int | None = None, **arguments: Sequence[float]) -> tuple[float, ...]:
    """Return the argument, a sequence of positive numbers, as a tuple; `count` is its length, if not None."""
    ((name, value),) = arguments.items()
    values = numbers(count, **arguments)
    if values.dtype != object and not (values.size and (values >= LEAST).all()):
        raise ValueError(f"{name}: must be positive numbers of {LEAST:g} or more, got {value!r}")
    return tuple(values.tolist())


def numbers(count: int | None = None, **arguments: ArrayLike) -> NDArray[np.float64]:
    """Return the argument as a flat array of finite floats; `count` is its length, if not None."""
    return array((count,), **arguments)


def _is_symbol(value: object) -> bool:
    """Return whether a value is a symbol, by which tracing replaces a number."""
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
    """Raise ZeroDivisionError if a value is zero, as Python's division does and NumPy's does not; symbols pass.

    A separate function, because a use of `dtype` in a traced function ends the trace.
    """
    if values.dtype != object and not values.all():
        raise ZeroDivisionError
