"""A plugin of pytest that keeps what became of each test, and why, in words for a student."""

import functools
import inspect
import linecache
import os
import traceback
from collections.abc import Callable, Generator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest

from tam570.checking.functions import Fault, Functions
from tam570.loading import said
from tam570.progress import FAILED, PASSED

__all__ = ["Failure", "Outcomes"]


@dataclass(frozen=True)
class Failure:
    """Why a test failed."""

    message: str
    function: str | None = None  # that is at fault for certain
    where: str = ""  # the line of the test
    printed: str = ""


@dataclass
class Outcomes:
    """Of each test, by its name with its parameters: the outcome, the failure, and how to run it again."""

    functions: Functions
    tests: Path
    log: str  # the file that names the test which runs
    terminal: int | None  # where to say so
    passed: dict[str, str] = field(default_factory=dict)  # PASSED or FAILED
    failures: dict[str, Failure] = field(default_factory=dict)
    again: dict[str, Callable[[], object]] = field(default_factory=dict)

    @pytest.hookimpl(wrapper=True)
    def pytest_pyfunc_call(self, pyfuncitem: Any) -> Generator[None, object, object]:
        name = _name(pyfuncitem.nodeid)
        wanted = inspect.signature(pyfuncitem.obj).parameters
        given = {one: value for one, value in pyfuncitem.funcargs.items() if one in wanted}
        self.again[name] = functools.partial(pyfuncitem.obj, **given)
        self.functions.called.clear()
        try:
            return (yield)
        except Fault as fault:
            self.failures[name] = Failure(str(fault), fault.name, self._line(fault))
        except (Exception, pytest.fail.Exception) as error:
            self.failures[name] = Failure(self._explained(error), None, self._line(error))
        return pytest.fail(self.failures[name].message, pytrace=False)

    def _explained(self, error: BaseException) -> str:
        """What a test says, or what an exception from it does."""
        text = str(error).strip()
        if text.startswith("DID NOT RAISE"):
            return "No ValueError is raised where one is asked for." if "ValueError" in text else text
        if isinstance(error, AssertionError | pytest.fail.Exception):
            return text or "This is not so."
        where = said(error, str(self.functions.file))
        return f"{self.functions.called[-1]} raises an exception.\n{where}" if where.startswith("Line") else where

    def _line(self, error: BaseException) -> str:
        lines = [one.lineno for one in traceback.extract_tb(error.__traceback__) if one.filename == str(self.tests)]
        return linecache.getline(str(self.tests), lines[-1] or 0).strip() if lines else ""

    @pytest.hookimpl
    def pytest_runtest_logstart(self, nodeid: str) -> None:
        Path(self.log).write_text(_name(nodeid), encoding="utf-8")
        if self.terminal is not None:
            os.write(self.terminal, f"\r\x1b[K{_name(nodeid)[:76]}".encode())

    @pytest.hookimpl
    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        name = _name(report.nodeid)
        if report.failed:
            self.passed[name] = FAILED
            known = self.failures.get(name) or Failure(report.longreprtext)
            self.failures[name] = Failure(known.message, known.function, known.where, report.capstdout)
        elif report.when == "call":
            self.passed.setdefault(name, PASSED)

    @pytest.hookimpl
    def pytest_collectreport(self, report: pytest.CollectReport) -> None:
        if report.failed:
            self.failures[self.tests.name] = Failure(report.longreprtext)


def _name(nodeid: str) -> str:
    """A test's name with its parameters."""
    return nodeid.partition("::")[2] or nodeid
