"""Frozen records of results, which keep all digits when they are written to disk and read."""

import base64
import math
from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any

import numpy as np

from tam570.values import Json, Numbers
from tam570_grader.checks.case import Case
from tam570_grader.checks.failure import Failure

FORMAT = 3  # version of result lines; lines of another version are refused
MAY_LACK = ("speed", "digest", "notebook", "unwritten", "error")  # fields that a line omits if they are empty
WRITTEN_OUT = 64  # most elements of an array that is written as a list; longer arrays are written as bytes


@dataclass(frozen=True)
class CheckResult:
    """The outcome of one check."""

    name: str
    part: str
    points: float | None
    max_points: float
    outcome: str  # passed, failed, not_run, grader_error
    message: str  # for the student
    suspect: str | None = None
    failure: Failure | None = None
    unwritten: str = ""  # the function that is missing or still the stub
    error: str = ""  # exception of the grader

    @property
    def unlocks_dependents(self) -> bool:
        """Whether the checks that depend on this one are run."""
        return self.outcome == "passed" or bool(self.failure and self.failure.near_miss)

    def record(self) -> Json:
        """Return the result as plain data for JSON, without fields that have their default values."""
        line = {key: value for key, value in vars(self).items() if value or key not in MAY_LACK}
        del line["failure"]
        if self.failure:
            usual = {field.name: field.default for field in fields(self.failure)}
            changed = {name: value for name, value in vars(self.failure).items() if value is not usual[name]}
            line["failure"] = {name: numbers(value) for name, value in changed.items()}
        return line


@dataclass(frozen=True)
class Result:
    """The outcome of one submission."""

    student: str
    assignment: str
    status: str  # graded, missing, unreadable, timeout, crashed
    score: float | None
    max_score: float
    seed: int
    seconds: float
    isolation: str
    checks: tuple[CheckResult, ...]
    message: str = ""
    speed: Json | None = None
    digest: str = ""  # digest of all that the result depends on
    notebook: bool = False  # the submission is a notebook
    format: int = FORMAT

    def record(self) -> Json:
        """Return the result line as plain data for JSON, without optional fields that are empty."""
        line = {**vars(self), "checks": [check.record() for check in self.checks]}
        return {key: value for key, value in line.items() if value or key not in (*MAY_LACK, "message")}


def read(line: Json) -> Result:
    """Return the result in a line; raise KeyError or TypeError if it contains none."""
    checks = tuple(CheckResult(**{**each, "failure": failure(each.get("failure"))}) for each in line["checks"])
    return Result(**{**line, "checks": checks})


def failure(line: Json | None) -> Failure | None:
    """Return the failure in the record of a check."""
    return None if line is None else Failure(**{key: _restored(value) for key, value in line.items()})


def numbers(value: object) -> Numbers:
    """Return a value as plain data without loss of digits: arrays as lists, long ones and NaN or infinity as bytes."""
    if isinstance(value, np.ndarray):
        if value.dtype.kind not in "fiub":
            return [numbers(item) for item in value.tolist()]
        return value.tolist() if value.size <= WRITTEN_OUT and np.isfinite(value).all() else _packed(value)
    if isinstance(value, np.generic):
        return numbers(value.item())
    if isinstance(value, Case):
        return {"args": numbers(value.args), "kwargs": numbers(value.kwargs)}
    if isinstance(value, Mapping):
        return {str(key): numbers(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [numbers(item) for item in value]
    if isinstance(value, float) and not math.isfinite(value):
        return _packed(np.array(value))  # JSON has no NaN and no infinity
    return value if value is None or isinstance(value, bool | int | float | str) else repr(value)[:400]


def _packed(value: np.ndarray) -> Json:
    array = np.asarray(value, "<f8", order="C")
    return {"shape": list(value.shape), "float64": base64.b64encode(array.tobytes()).decode()}


def _restored(value: Any) -> Any:
    if isinstance(value, dict):
        if value.keys() == {"shape", "float64"}:
            array = np.frombuffer(base64.b64decode(value["float64"]), "<f8").reshape(value["shape"])
            return array if array.ndim else float(array)
        return {key: _restored(item) for key, item in value.items()}
    return [_restored(item) for item in value] if isinstance(value, list) else value
