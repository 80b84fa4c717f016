"""The student's functions, called with care: what goes wrong in them is said in a sentence or two."""

import sys
import traceback
from collections.abc import Callable, Sequence
from pathlib import Path
from types import ModuleType
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from tam570.loading import Trouble, said
from tam570.loading import loaded as load_file
from tam570.values import Function, Numbers

__all__ = ["Student", "Trouble", "load_student", "numbers", "rows_missing"]

Array = NDArray[np.float64]
Made = TypeVar("Made")


def load_student(file: Path, slug: str) -> ModuleType:
    """Return the module in a file or notebook, imported under the assignment's name. Trouble if it cannot be."""
    module, _ = load_file(file, slug)
    module.__file__ = str(file)
    sys.modules[slug] = module
    return module


class Student:
    """`student(name, ...)` calls the function of that name and gives its numbers.

    notes : what could not be shown, and why
    """

    def __init__(self, module: ModuleType) -> None:
        self._module = module
        self._file = str(getattr(module, "__file__", None) or "")
        self.notes: list[str] = []

    def make_each(self, *makers: Callable[[], Made]) -> list[Made]:
        """Return what can be made of what a scene shows beside the motion; the notes tell why the rest cannot."""
        shapes = []
        for maker in makers:
            try:
                shapes.append(maker())
            except Trouble as trouble:
                self.notes.append(str(trouble))
        return shapes

    def function(self, name: str) -> Function:
        """Return the student's function itself. Trouble if there is none."""
        function = getattr(self._module, name, None)
        if not callable(function):
            raise Trouble(f"there is no function {name}{f' in {self._file}' if self._file else ''}")
        return function  # type: ignore[no-any-return]

    def __call__(
        self, name: str, *arguments: Numbers, shape: Sequence[int] | None = None, **parameters: Numbers
    ) -> Array:
        """Return what the function returns, as an array of this shape. Trouble if it does not, or is not finite."""
        return self._finite(name, numbers(name, self._raw(name, *arguments, **parameters), shape))

    def group(
        self, name: str, *arguments: Numbers, shapes: Sequence[Sequence[int]], **parameters: Numbers
    ) -> list[Array]:
        """Return the arrays that the function returns together, each of its shape."""
        result = self._raw(name, *arguments, **parameters)
        if not isinstance(result, Sequence | np.ndarray) or len(result) != len(shapes):
            raise Trouble(f"{name} gives {_short(result)}; {len(shapes)} results are asked for")
        return [self._finite(name, numbers(name, part, shape)) for part, shape in zip(result, shapes, strict=True)]

    def _raw(self, name: str, *arguments: Numbers, **parameters: Numbers) -> Numbers:
        """Return what the function returns, whatever it is."""
        return self._guarded(name, lambda function: function(*arguments, **parameters))

    def each(self, name: str, *rows: Numbers, shape: Sequence[int] = (), **parameters: Numbers) -> Array:
        """(n, *shape) of the function called with row i of every argument in turn."""
        results = self.returned(name, *rows, **parameters)
        try:  # all at once: one by one takes longer than the student's function
            values = np.array(results)
        except ValueError:  # of different shapes
            values = np.array([numbers(name, result, shape) for result in results])
        if values.shape[1:] != tuple(shape):
            numbers(name, results[0], shape)
        return self._finite(name, numbers(name, values, (len(results), *shape)))

    def returned(self, name: str, *rows: Numbers, **parameters: Numbers) -> list[Numbers]:
        """Return what the function returns for row i of every argument in turn, whatever it is."""
        calls = [*zip(*rows, strict=True)]
        return [*self._guarded(name, lambda function: [function(*row, **parameters) for row in calls])]

    def _guarded(self, name: str, use: Callable[[Function], Numbers]) -> Numbers:
        function = self.function(name)
        try:
            return use(function)
        except NotImplementedError as error:
            *_, last = traceback.extract_tb(error.__traceback__)
            raise Trouble(f"{last.name} is not written yet") from error
        except (Exception, SystemExit) as error:
            raise Trouble(f"{name} raises an exception\n{said(error, self._file)}") from error

    def _finite(self, name: str, values: Array) -> Array:
        if np.isfinite(values).all():
            return values
        if values.ndim < 2 or len(values) < 2:
            raise Trouble(f"{name} gives numbers that are not finite: {values}")
        rows = np.all(np.isfinite(values.reshape(len(values), -1)), axis=1, keepdims=True)
        raise Trouble(f"{name} gives numbers that are not finite, first in row {rows.argmin()} of {len(rows)}")


def numbers(name: str, result: Numbers, shape: Sequence[int] | None) -> Array:
    """Return a result as an array of this shape, any if None. Trouble if it is not one, in words for a student."""
    try:
        values = np.asarray(result)
        if values.dtype.kind == "O":  # of SymPy, say
            values = np.reshape([float(value) for value in values.ravel()], values.shape)
        if values.dtype.kind not in "biuf":
            raise TypeError
        values = values.astype(float)
    except (TypeError, ValueError):
        raise Trouble(f"{name} gives no numbers but {_short(result)}") from None
    if shape is not None and values.shape != tuple(shape):
        missing = rows_missing(values, shape)
        raise Trouble(f"{name} gives an array of shape {values.shape}; {tuple(shape)} is asked for{missing}")
    return values


def rows_missing(values: Array, shape: Sequence[int | None]) -> str:
    """Ask where the rows are, if there are some and too few; else ""."""
    is_short = len(shape) == values.ndim > 1 and 0 < len(values) < (shape[0] or 0)
    return ". Rows are missing: did the integration stop early?" if is_short else ""


def _short(result: object) -> str:
    text = repr(result)
    return text if len(text) <= 60 else f"{text[:57]}..."
