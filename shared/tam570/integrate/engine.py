"""From a right-hand side to the functions that step it: traced where it can be, else called as it stands.

What was traced is kept for the next run of a right-hand side with the same fingerprint: it was compared with the
student's function then, and nothing that it depends on has changed since.
"""

from collections.abc import Callable, Hashable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, NamedTuple

from tam570.integrate.adaptive_loop import first_step_with, loop_with
from tam570.integrate.arguments import Array
from tam570.integrate.binding import Rates, agrees, bound, check_start, floats_function, reversed_rates
from tam570.integrate.dop853_source import compiled
from tam570.integrate.fingerprint import Changeable, fingerprint
from tam570.integrate.formulas import Formulas, call_of, written
from tam570.integrate.symbols import Untraceable
from tam570.integrate.trace import Graph, traced

__all__ = ["Engine", "engine"]


@dataclass(frozen=True, eq=False)
class Engine:
    """The functions generated for a right-hand side, and the constants of its scene."""

    rates: Rates  # the right-hand side itself
    functions: dict[str, Any]
    constants: tuple[float, ...]
    formulas: Formulas
    graph: Graph | None  # None where the right-hand side is called as it stands
    why: str = ""  # it is not traced
    sign: float = 1.0  # of the clock: -1 where the times are those of -t

    @property
    def traced(self) -> bool:
        return self.graph is not None


def engine(
    rhs: Callable[..., Any],
    parameters: Mapping[str, Any] | None,
    times: Array,
    start: Array,
    *,
    sign: float = 1.0,
    sampled: bool = False,
) -> Engine:
    """Functions for the right-hand side as traced, if it can be and agrees; else for calls of it.

    sign    : of the clock; -1 where the times are those of -t
    sampled : states inside of steps will be asked for, not only where there are more than two times
    """
    sampled = sampled or len(times) > 2
    asked = _Asked(rhs, parameters, times, start, sampled, sign)
    try:
        held = fingerprint(rhs), fingerprint(dict(parameters)) if parameters else None
        place = _place((*held, len(start), sampled, sign))
        if not place:
            place.append(_made(asked))
        found = place[0]
    except Changeable:
        found = _made(asked)
    return found if isinstance(found, Engine) else _called(asked, found)


@lru_cache(maxsize=256)
def _place(key: Hashable) -> list[Any]:
    """Where the engine is kept that was made for this key, or why there is none."""
    return []


class _Asked(NamedTuple):
    """What an engine is made of."""

    rhs: Callable[..., Any]
    parameters: Mapping[str, Any] | None
    times: Array
    start: Array
    sampled: bool
    sign: float

    def rates(self) -> Rates:
        """The right-hand side, tried at the start."""
        rates = bound(self.rhs, self.parameters)
        rates = rates if self.sign > 0 else reversed_rates(rates)
        check_start(rates, float(self.times[0]), self.start, self.sign)
        return rates


def _made(asked: _Asked) -> Engine | str:
    """The engine of a traced right-hand side; or why it is not traced."""
    rates = asked.rates()
    try:
        graph = traced(rates, len(asked.start))
    except Untraceable as reason:
        return str(reason)
    formulas, constants = written(graph)
    found = Engine(rates, _functions(formulas, asked.sampled), constants, formulas, graph, sign=asked.sign)
    if agrees(rates, found.functions["rhs"], constants, asked.times, asked.start):
        return found
    return "its formulas as traced give other numbers than it does"


def _called(asked: _Asked, why: str) -> Engine:
    rates = asked.rates()
    given = floats_function(rates, float(asked.times[0]), asked.start)
    formulas = call_of(len(asked.start))
    functions = _with_loop(compiled(formulas, asked.sampled, given))
    return Engine(rates, functions, (), formulas, None, why, asked.sign)


@lru_cache(maxsize=256)
def _functions(formulas: Formulas, sampled: bool) -> dict[str, Any]:
    return _with_loop(compiled(formulas, sampled))


def _with_loop(functions: dict[str, Any]) -> dict[str, Any]:
    """The generated functions and the loop around them."""
    first_step = first_step_with(functions["rhs"], functions["euler"])
    advance = loop_with(*(functions[name] for name in ("raised", "step", "dense", "at")))
    return {**functions, "first_step": first_step, "advance": advance}
