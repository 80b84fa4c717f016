"""Known mistakes, told by the student's own numbers: a test that fails would pass if a result were changed like this.

Nothing about an assignment is in here but the names and units that its docstrings give.
"""

import re
import sys
from collections.abc import Callable, Hashable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial

import numpy as np

from tam570.checking.promises import Promise
from tam570.course import Stub
from tam570.values import Function, Json, Numbers, Parameters

__all__ = ["Mistake", "candidates", "tightened"]

UNIT = re.compile(r"^\s*(\w+(?:, \w+)*)\s*: (?:\([^)]*\) )?rad\b", re.MULTILINE)
TIGHT = 1e-9
INTEGRATORS = {"solve_ivp": ("rtol", "atol"), "odeint": ("rtol", "atol")}  # and the names of their tolerances
Change = Callable[[Numbers], Numbers]


@contextmanager
def tightened(names: Json) -> Iterator[None]:
    """Let SciPy's integrators, under whatever name a module has them, keep to TIGHT."""
    integrate = sys.modules.get("scipy.integrate")
    integrators = {getattr(integrate, name): name for name in INTEGRATORS} if integrate else {}
    places = [vars(integrate), names] if integrate else []
    replaced = [
        (namespace, key, value) for namespace in places for key, value in namespace.items() if _in(integrators, value)
    ]
    for namespace, key, value in replaced:
        namespace[key] = partial(_tight, value, integrators[value])
    try:
        yield
    finally:
        for namespace, key, value in replaced:
            namespace[key] = value


def _in(integrators: Mapping[Numbers, str], value: Numbers) -> bool:
    return callable(value) and isinstance(value, Hashable) and value in integrators


def _tight(integrator: Function, name: str, *args: Numbers, **how: Numbers) -> Numbers:
    for tolerance in INTEGRATORS[name]:
        how[tolerance] = np.minimum(how.get(tolerance) or TIGHT, TIGHT)
    return integrator(*args, **how)


@dataclass(frozen=True)
class Mistake:
    """A change of one function's results, or of its arguments, that may make tests pass."""

    function: str
    message: str  # "the transpose of what rotation_matrix gives"
    result: Callable[[Numbers, Parameters], Numbers] | None = None
    argument: tuple[str, Change] | None = None
    tight: bool = False  # the function's integrators at TIGHT

    def applied(self, function: Function, args: Sequence[Numbers], kwargs: Parameters) -> Numbers:
        """Return the function's result with the change."""
        if self.argument is not None:
            args, kwargs = _changed(self.argument, args, dict(kwargs))
        result = function(*args, **kwargs)
        return result if self.result is None else self.result(result, kwargs)


def candidates(name: str, stub: Stub, returns: Promise) -> Iterator[Mistake]:
    """Yield the mistakes that a function of this form can have, the most telling first."""
    angles = {name for match in UNIT.finditer(stub.docstring) for name in match[1].split(", ")}
    if ["n"] in [member.get("array", [])[:1] for member in returns.get("group", [returns])]:
        yield Mistake(name, f"the tolerances rtol=1e-9, atol=1e-9 in {name}", tight=True)
    yield from _of_results(name, returns)
    for index, argument in enumerate(stub.positions):
        yield from _of_argument(name, index, argument, argument in angles)
    for argument in stub.keywords:
        yield from _of_factor(name, argument)
    if "array" in returns:
        for factor, message in ((2.0, "twice"), (0.5, "half of")):
            yield Mistake(name, f"{message} what {name} gives", _whole(partial(np.multiply, factor)))


def _of_results(name: str, returns: Promise) -> Iterator[Mistake]:
    if "group" in returns:
        yield from _of_members(name, returns["group"])
    if "array" not in returns:
        return
    shape = returns["array"]
    if len(shape) == 2 and shape[0] == shape[1]:
        yield Mistake(name, f"the transpose of what {name} gives", _whole(np.transpose))
    yield Mistake(name, f"the opposite sign of what {name} gives", _whole(np.negative))
    yield Mistake(name, f"what {name} gives in radians, as if it were in degrees", _whole(np.radians))
    if shape[:1] == ["n"]:
        yield Mistake(name, f"the angles of {name} not wrapped to one turn", _whole(lambda a: np.unwrap(a, axis=0)))
    if len(shape) in (1, 2) and isinstance(shape[-1], int) and (len(shape) == 1 or shape[0] == "n"):
        yield from _of_components(name, shape[-1], "column" if len(shape) == 2 else "component")


def _of_components(name: str, size: int, word: str) -> Iterator[Mistake]:
    for index in range(size):
        flip = np.where(np.arange(size) == index, -1.0, 1.0)
        message = f"the opposite sign of {word} {index + 1} of what {name} gives"
        yield Mistake(name, message, _whole(partial(np.multiply, flip)))
    if size in (2, 3):
        yield Mistake(
            name, f"the {word}s of {name} in the opposite order", _whole(lambda a: np.flip(np.asarray(a), axis=-1))
        )


def _of_members(name: str, promises: Sequence[Promise]) -> Iterator[Mistake]:
    for index, returns in enumerate(promises):
        for mistake in _of_results(f"{name} (result {index + 1})", returns):
            yield Mistake(name, mistake.message, _member(index, mistake.result))
    if len(promises) == 2 and promises[0] == promises[1]:
        yield Mistake(name, f"the two results of {name} in the opposite order", lambda r, k: list(r)[::-1])


def _member(index: int, change: Numbers) -> Callable[[Numbers, Parameters], Numbers]:
    return lambda result, kwargs: [*result[:index], change(result[index], kwargs), *result[index + 1 :]]


def _of_argument(name: str, index: int, argument: str, angle: bool) -> Iterator[Mistake]:
    def mistake(message: str, change: Change) -> Mistake:
        return Mistake(name, message, argument=(f"{index}:{argument}", change))

    if angle:
        yield mistake(f"`{argument}` given to {name} in degrees: it is in radians", np.degrees)
        yield mistake(f"the opposite sign of the `{argument}` of {name}", np.negative)
    if argument in ("axis", "n"):
        yield mistake(f"`{argument}` made a unit vector before {name} uses it", _unit)
    if argument == "t" and index == 0:
        yield mistake(
            f"times from zero on in {name}: the first time is t[0], not always 0", lambda t: np.asarray(t) - t[0]
        )


def _of_factor(name: str, parameter: str) -> Iterator[Mistake]:
    for word, power in (("times", 1), ("divided by", -1)):

        def change(result: Numbers, kwargs: Parameters, power: int = power) -> Numbers:
            return np.asarray(result, float) * np.asarray(kwargs[parameter], float) ** power

        yield Mistake(name, f"what {name} gives {word} `{parameter}`", change)


def _whole(change: Change) -> Callable[[Numbers, Parameters], Numbers]:
    return lambda result, kwargs: change(np.asarray(result, float))


def _unit(axis: Numbers) -> Numbers:
    return np.asarray(axis) / np.linalg.norm(axis)


def _changed(argument: tuple[str, Change], args: Sequence[Numbers], kwargs: Json) -> tuple[Numbers, Json]:
    """Return the arguments with one of them changed, given by its place or by its name."""
    position, _, name = argument[0].partition(":")
    if name in kwargs:
        return args, {**kwargs, name: argument[1](kwargs[name])}
    index = int(position)
    return [*args[:index], argument[1](args[index]), *args[index + 1 :]], kwargs
