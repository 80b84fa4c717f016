"""Wrappers of the student's functions for the tests, which enforce the grader's rules and report errors at once."""

import functools
import time
import traceback
from collections.abc import Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager, nullcontext
from dataclasses import dataclass, field
from pathlib import Path
from types import ModuleType

import numpy as np

from tam570.bans import HERE, Change, Forbidden, Unusable, refused
from tam570.checking.deadline import CALL, TooLong, limited
from tam570.checking.mistakes import CallArguments, Candidate, ObservedCall, tightened
from tam570.checking.trail import Trail
from tam570.checking.transforms import parts
from tam570.forms import Form, WrongForm, conform
from tam570.loading import replaced, said
from tam570.values import Function, Numbers


class Fault(BaseException):
    """An error in a call of the student's function `name`; the message is for the student."""

    def __init__(self, name: str, message: str, *, unwritten: bool = False) -> None:
        super().__init__(message)
        self.name, self.unwritten = name, unwritten


@dataclass
class Functions:
    """A student's module, and a record of the calls of its functions."""

    module: ModuleType
    file: Path
    results: Mapping[str, Form]
    off_limits: Mapping[str, Sequence[str]]
    calls: list[str] = field(default_factory=list)  # in the current test, in order
    mistake: Candidate | None = None  # whose repair is being tried
    everywhere: bool = False  # whether calls by the module's other functions are repaired, too
    informative: bool = False  # whether some repaired result is not zero
    parameters: set[str] = field(default_factory=set)  # keyword arguments of the repaired calls
    cache: dict[tuple[str, bool, bytes], Numbers] = field(default_factory=dict)  # results by function and arguments
    observed: dict[str, ObservedCall] = field(default_factory=dict)  # the first call of each function
    hanging: dict[str, str] = field(default_factory=dict)  # functions not to call again, and why
    trail: Trail = field(default_factory=Trail)
    total: float = 0.0  # s of processor time of all calls
    longest: dict[str, float] = field(default_factory=dict)  # s of processor time of a function's longest call
    depth: int = 0

    def stand_in(self) -> ModuleType:
        """Return the module that the tests import in place of the student's."""
        stand_in = ModuleType(self.module.__name__)
        stand_in.__dict__.update({k: v for k, v in vars(self.module).items() if k != "__builtins__"})
        for name in self.results:
            function = getattr(self.module, name, None)
            setattr(stand_in, name, self._watched(name, function) if callable(function) else self._missing(name))
        return stand_in

    def _missing(self, name: str) -> Function:
        def missing(*args: Numbers, **kwargs: Numbers) -> Numbers:
            raise Fault(name, f"Your file has no function {name}.")

        return missing

    def _watched(self, name: str, function: Function) -> Function:
        @functools.wraps(function)
        def wrapper(*args: Numbers, **kwargs: Numbers) -> Numbers:
            self.calls.append(name)
            arguments = CallArguments(args, kwargs)
            if self.depth:  # in a call by another of the student's functions
                return self._repaired(name, arguments, function(*args, **kwargs))
            with tightened(vars(self.module)) if self._is_tight(name) else nullcontext():
                return self._repaired(name, arguments, self._result(name, function, arguments))

        return wrapper

    def _is_tight(self, name: str) -> bool:
        """Return whether the mistake that is being tried is that this function's tolerances are too loose."""
        return self.mistake is not None and self.mistake.function == name and self.mistake.repair is None

    def _repaired(self, name: str, arguments: CallArguments, result: Numbers) -> Numbers:
        """Return the result, repaired if a mistake of this function is being tried."""
        if self.mistake is None or self.mistake.function != name or self.mistake.repair is None:
            return result
        repaired = self.mistake.repair(ObservedCall(arguments, result))
        self.parameters.add(str(arguments.kwargs))
        self.informative = self.informative or any(map(np.any, parts(repaired)))
        return repaired

    @contextmanager
    def tried(self, mistake: Candidate, *, everywhere: bool = False) -> Iterator[None]:
        """Repair a mistake in the tests' calls of a function; with `everywhere`, also in calls by the module itself."""
        before = getattr(self.module, mistake.function)
        self.mistake, self.everywhere = mistake, everywhere
        if everywhere:
            setattr(self.module, mistake.function, self._watched(mistake.function, before))
        try:
            yield
        finally:
            self.mistake, self.everywhere = None, False
            setattr(self.module, mistake.function, before)

    def plain(self, name: str) -> Function:
        """Return a student's function without repair; while a mistake is tried, its results are cached."""
        function = getattr(self.module, name)
        return functools.wraps(function)(
            lambda *args, **kwargs: self._result(name, function, CallArguments(args, kwargs))
        )

    def _result(self, name: str, function: Function, arguments: CallArguments) -> Numbers:
        """Return the function's result, from the cache while mistakes are tried.

        Raise Fault if it has not the form of the contract.
        """
        key = (name, self._is_tight(name), _contents(arguments))
        if self.everywhere:  # results change with repairs inside the call
            return self._called(name, function, arguments)
        if self.mistake is None or key not in self.cache:
            self.cache[key] = self._called(name, function, arguments)
        try:
            conform(self.results[name], self.cache[key], name, arguments.args)
        except WrongForm as wrong:
            raise Fault(name, wrong.sentences) from None
        self.observed.setdefault(name, ObservedCall(arguments, self.cache[key]))
        return self.cache[key]

    def _called(self, name: str, function: Function, arguments: CallArguments) -> Numbers:
        if name in self.hanging:
            raise Fault(name, self.hanging[name])
        self.trail.enter(function=name)
        before, started = _contents(arguments), time.process_time()
        try:
            with self._fair(name):
                result = function(*arguments[0], **arguments[1])
        finally:
            seconds = time.process_time() - started
            self.total += seconds
        self.longest[name] = max(seconds, self.longest.get(name, 0.0))
        if _contents(arguments) != before:
            raise Fault(name, f"{name} changes the arrays that it is given. Work on copies: the grader refuses this.")
        return result

    @contextmanager
    def _fair(self, name: str) -> Iterator[None]:
        """Apply the grader's rules to a call. Raise Fault if it fails; pass ValueError on, which tests may expect."""
        self.depth += 1
        try:
            with ExitStack() as rules:
                rules.enter_context(replaced(self.off_limits.get("*", ()), HERE))
                rules.enter_context(self._without(name))
                rules.enter_context(limited())
                yield
        except TooLong:
            self.hanging[name] = f"{name} did not return within {CALL:g} s in a test before; it is not called again."
            raise Fault(
                name, f"{name} did not return within {CALL:g} s. The grader ends such a call: is there an endless loop?"
            ) from None
        except NotImplementedError as error:
            last = traceback.extract_tb(error.__traceback__)[-1].name
            raise Fault(last if last in self.results else name, f"{last} is not written yet.", unwritten=True) from None
        except (Fault, ValueError):
            raise
        except (Exception, SystemExit) as error:
            what = "" if isinstance(error, Forbidden) else f"{name} raises an exception.\n"
            raise Fault(name, f"{what}{said(error, str(self.file))}") from error
        finally:
            self.depth -= 1

    @contextmanager
    def _without(self, name: str) -> Iterator[None]:
        """Replace what is banned in this function only, while it is called."""
        banned, where = tuple(self.off_limits.get(name, ())), f"in {name}"
        changes: list[Change] = [
            (self.module, key, Unusable(origin, where))
            for key, value in vars(self.module).items()
            if (origin := _origin(value)).startswith(banned)
        ]
        for member in (member for member in banned if hasattr(self.module, member)):
            changes += refused(self.module, member, Unusable(member, where))
        before = [(owner, attribute, getattr(owner, attribute)) for owner, attribute, _ in changes]
        with replaced(banned, where):
            for owner, attribute, value in changes:
                setattr(owner, attribute, value)
            try:
                yield
            finally:
                for owner, attribute, value in before:
                    setattr(owner, attribute, value)


def _origin(value: Numbers) -> str:
    """Return the name of the module that a value is, or comes from."""
    return value.__name__ if isinstance(value, ModuleType) else str(getattr(value, "__module__", None))


def _contents(arguments: CallArguments) -> bytes:
    """Return the arguments' values as bytes, to detect changes; other objects, such as Axes, may change."""
    values = [*arguments[0], *(value for pair in arguments[1].items() for value in pair)]
    return b"\0".join(_bytes(value) for value in values)


def _bytes(value: Numbers) -> bytes:
    if hasattr(value, "tobytes"):
        return bytes(value.tobytes())
    return repr(value if isinstance(value, list | tuple | str | int | float) else id(value)).encode()
