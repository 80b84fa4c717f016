"""Find mistakes from a student's numbers: changes of a result or argument with which a failed test passes.

The changes are inverses of transforms that the grader applies to the right function.
"""

import sys
from collections.abc import Callable, Hashable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from typing import NamedTuple

import numpy as np

from tam570.checking.transforms import WrongArgument, undone
from tam570.forms import Form
from tam570.values import Function, Json, Numbers, Parameters

BEGINNING = "Your numbers match this mistake: "
TIGHT = 1e-9  # rtol and atol of SciPy's integrators
QUICK = 0.01  # s: only functions that take less are called with many other arguments
INTEGRATORS = ("solve_ivp", "odeint")


@contextmanager
def tightened(names: Json) -> Iterator[None]:
    """Limit the tolerances of SciPy's integrators to TIGHT in this block, under any name that a module has for them."""
    integrate = sys.modules.get("scipy.integrate")
    integrators: set[Function] = {getattr(integrate, name) for name in INTEGRATORS} if integrate else set()
    replaced: list[tuple[Json, str, Function]] = [
        (namespace, key, value)
        for namespace in ([vars(integrate), names] if integrate else [])
        for key, value in namespace.items()
        if callable(value) and isinstance(value, Hashable) and value in integrators
    ]
    for namespace, key, value in replaced:
        namespace[key] = partial(_tight, value)
    try:
        yield
    finally:
        for namespace, key, value in replaced:
            namespace[key] = value


def _tight(integrator: Function, *args: Numbers, **how: Numbers) -> Numbers:
    for tolerance in ("rtol", "atol"):
        how[tolerance] = np.minimum(how.get(tolerance) or TIGHT, TIGHT)
    return integrator(*args, **how)


class CallArguments(NamedTuple):
    """The arguments of a call."""

    args: tuple[Numbers, ...]
    kwargs: Parameters


class ObservedCall(NamedTuple):
    """A call of a student's function; `expected` is its result, from which a repair computes the right one."""

    case: CallArguments
    expected: Numbers
    result: Numbers = None


@dataclass(frozen=True)
class Candidate:
    """A possible mistake in a function.

    repair : computes the result with the mistake undone; None: the function runs in `tightened`
    """

    function: str
    message: str
    repair: Callable[[ObservedCall], Numbers] | None

    @property
    def is_a_number(self) -> bool:
        """Whether the mistake is a factor 2, 1/2 or sqrt(2), which a parameter may equal if all calls have the same."""
        return any(words in self.message for words in (" twice", " half", "sqrt(2)"))


def candidates(
    name: str, returns: Form, function: Function, example: ObservedCall, seconds: float
) -> Iterator[Candidate]:
    """Yield the possible mistakes of a function with results of this form, the most informative first.

    seconds : duration of the function's longest call
    """
    if ["n"] in [member.get("array", [])[:1] for member in returns.get("group", [returns])]:
        yield Candidate(name, f"It would pass with the tolerances rtol=1e-9, atol=1e-9 in {name}.", None)
    if "array" in returns or "group" in returns:
        for words, repair in undone(name, function, example, seconds < QUICK):
            yield Candidate(name, f"{BEGINNING}{words}.", repair)


def reversed_argument(mistake: Candidate) -> str:
    """Return the argument whose sign the mistake reverses; "" for any other mistake."""
    repair = mistake.repair
    return repair.key if isinstance(repair, WrongArgument) and repair.change is np.negative else ""
