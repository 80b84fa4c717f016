"""Mistakes told by the student's own numbers: a failed test would pass if a result or an argument were changed back.

They are the changes that the grader tries on the right function.
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
TIGHT = 1e-9
QUICK = 0.01  # s of a call, up to which it is made with many other arguments
INTEGRATORS = ("solve_ivp", "odeint")


@contextmanager
def tightened(names: Json) -> Iterator[None]:
    """Let SciPy's integrators, under whatever name a module has them, keep to TIGHT."""
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
    """A call of a student's function and what it gives, which a change of it would make right."""

    case: CallArguments
    expected: Numbers
    result: Numbers = None


@dataclass(frozen=True)
class Candidate:
    """What may be wrong with a function.

    repair : what the function gives where the mistake is undone; None: its integrators keep to TIGHT
    """

    function: str
    message: str
    repair: Callable[[ObservedCall], Numbers] | None

    @property
    def is_a_number(self) -> bool:
        """Whether it is a factor 2, which in calls with one set of parameters one of these may be."""
        return any(words in self.message for words in (" twice", " half", "sqrt(2)"))


def candidates(
    name: str, returns: Form, function: Function, example: ObservedCall, seconds: float
) -> Iterator[Candidate]:
    """Yield the mistakes that a function of this form can have, the most telling first.

    seconds : of its longest call
    """
    if ["n"] in [member.get("array", [])[:1] for member in returns.get("group", [returns])]:
        yield Candidate(name, f"It would pass with the tolerances rtol=1e-9, atol=1e-9 in {name}.", None)
    if "array" in returns or "group" in returns:
        for words, repair in undone(name, function, example, seconds < QUICK):
            yield Candidate(name, f"{BEGINNING}{words}.", repair)


def reversed_argument(mistake: Candidate) -> str:
    """Return the argument of which the mistake reverses the sign; "" of another mistake."""
    repair = mistake.repair
    return repair.key if isinstance(repair, WrongArgument) and repair.change is np.negative else ""
