"""The student's functions, called with care: what goes wrong in them is said in a sentence or two."""

import sys
import traceback
from collections.abc import Callable, Mapping
from pathlib import Path
from types import ModuleType
from typing import TypeVar

import numpy as np

from tam570.forms import Form, WrongForm, conform
from tam570.loading import Trouble, said
from tam570.loading import loaded as load_file
from tam570.show.scene import Array
from tam570.values import Function, Numbers

Made = TypeVar("Made")


def load_student(file: Path, slug: str) -> ModuleType:
    """Return the module in a file or notebook, imported under the assignment's name. Trouble if it cannot be."""
    module, _ = load_file(file, slug)
    module.__file__ = str(file)
    sys.modules[slug] = module
    return module


class StudentModule:
    """`student(name, ...)` calls the function of that name and gives its result in the form that the contract has.

    forms : of the results, by function
    notes : what could not be shown, and why
    """

    def __init__(self, module: ModuleType, forms: Mapping[str, Form]) -> None:
        self._module, self._forms = module, forms
        self._file = str(getattr(module, "__file__", None) or "")
        self.notes: list[str] = []

    def make_each(self, *makers: Callable[[], Made]) -> list[Made]:
        """Return what can be made of what a scene shows beside the motion; the notes tell why the rest cannot."""
        results = []
        for maker in makers:
            try:
                results.append(maker())
            except Trouble as trouble:
                self.notes.append(str(trouble))
        return results

    def function(self, name: str) -> Function:
        """Return the student's function itself. Trouble if there is none."""
        function = getattr(self._module, name, None)
        if not callable(function):
            raise Trouble(f"there is no function {name}{f' in {self._file}' if self._file else ''}")
        return function

    def __call__(self, name: str, *arguments: Numbers, **parameters: Numbers) -> Numbers:
        """Return what the function returns. Trouble if it has another form, or is not finite."""
        result = self._guarded(name, lambda function: function(*arguments, **parameters))
        return _conformed(self._forms[name], result, name, arguments)

    def each(self, name: str, *rows: Numbers, **parameters: Numbers) -> Array:
        """(n, ...) of the function called with row i of every argument in turn."""
        form, results = self._forms[name], self._results(name, *rows, **parameters)
        sizes = form["array"] if "array" in form else [len(form["group"])]
        try:  # all at once: one by one takes longer than the student's function
            return np.asarray(conform({"array": ["n", *sizes]}, results, name, (results,)))
        except WrongForm as error:
            if where := _first_row(error.actual):
                raise Trouble(f"{error}{where}") from None
            return np.array([_conformed(form, result, name) for result in results])

    def one_by_one(self, name: str, *rows: Numbers, **parameters: Numbers) -> list[Numbers]:
        """Return what the function returns for row i of every argument in turn, as it is."""
        return [_conformed(self._forms[name], result, name) for result in self._results(name, *rows, **parameters)]

    def _results(self, name: str, *rows: Numbers, **parameters: Numbers) -> list[Numbers]:
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


def _conformed(form: Form, result: Numbers, name: str, arguments: Numbers = ()) -> Numbers:
    try:
        return conform(form, result, name, arguments)
    except WrongForm as error:
        raise Trouble(f"{error}{_first_row(error.actual) or (error.hint and f'. {error.hint}')}") from None


def _first_row(values: Numbers) -> str:
    """Return where the first number is that is not finite, of a table of numbers."""
    if np.ndim(values) < 2 or np.isfinite(values).all():
        return ""
    rows = np.isfinite(values).reshape(len(values), -1).all(axis=1)
    return f", first in row {rows.argmin()} of {len(rows)}"
