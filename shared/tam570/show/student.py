"""Call a student's functions; report their errors in a sentence or two."""

import sys
import traceback
from collections.abc import Callable, Mapping
from pathlib import Path
from types import ModuleType
from typing import TypeVar

import numpy as np

from tam570.forms import Form, WrongForm, conform
from tam570.loading import Trouble, loaded, said
from tam570.show.scene import Array
from tam570.values import Function, Numbers

Made = TypeVar("Made")


def load_student(file: Path, slug: str) -> ModuleType:
    """Import a file or notebook as a module with the assignment's name. Raise Trouble if that fails."""
    module, _ = loaded(file, slug)
    module.__file__ = str(file)
    sys.modules[slug] = module
    return module


class StudentModule:
    """A student's module: `student(name, ...)` calls a function and returns its result in the form of the contract.

    forms : of the results, by function
    notes : what could not be shown, and why
    """

    def __init__(self, module: ModuleType, forms: Mapping[str, Form]) -> None:
        self._module, self._forms = module, forms
        self._file = str(getattr(module, "__file__", None) or "")
        self.notes: list[str] = []

    def make_each(self, *makers: Callable[[], Made]) -> list[Made]:
        """Return the results of the makers that raise no Trouble; add the messages of the others to the notes."""
        results = []
        for maker in makers:
            try:
                results.append(maker())
            except Trouble as trouble:
                self.notes.append(str(trouble))
        return results

    def function(self, name: str) -> Function:
        """Return the student's function. Raise Trouble if there is none."""
        function = getattr(self._module, name, None)
        if not callable(function):
            raise Trouble(f"there is no function {name}{f' in {self._file}' if self._file else ''}")
        return function

    def __call__(self, name: str, *arguments: Numbers, **parameters: Numbers) -> Numbers:
        """Return the function's result. Raise Trouble if it has another form, or is not finite."""
        result = self._guarded(name, lambda function: function(*arguments, **parameters))
        return _conformed(self._forms[name], result, name, arguments)

    def each(self, name: str, *rows: Numbers, **parameters: Numbers) -> Array:
        """Return (n, ...) the function's results for row i of every argument."""
        form, results = self._forms[name], self._results(name, *rows, **parameters)
        sizes = form["array"] if "array" in form else [len(form["group"])]
        try:  # all at once, which is faster
            return np.asarray(conform({"array": ["n", *sizes]}, results, name, (results,)))
        except WrongForm as error:
            if where := _first_row(error.actual):
                raise Trouble(f"{error}{where}") from None
            return np.array([_conformed(form, result, name) for result in results])

    def one_by_one(self, name: str, *rows: Numbers, **parameters: Numbers) -> list[Numbers]:
        """Return a list of the function's results for row i of every argument."""
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
    """Return a phrase with the first row of a table that has a number that is not finite; "" if there is none."""
    if np.ndim(values) < 2 or np.isfinite(values).all():
        return ""
    rows = np.isfinite(values).reshape(len(values), -1).all(axis=1)
    return f", first in row {rows.argmin()} of {len(rows)}"
