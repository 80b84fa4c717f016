"""From a right-hand side to the functions that step it: traced where it can be, else called as it stands.

What was traced is kept for the next run of a right-hand side with the same fingerprint: it was compared with the
student's function then, and nothing that it depends on has changed since.
"""

from collections.abc import Callable, Hashable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

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
    given = rhs, parameters, times, start, sampled, sign
    try:
        held = fingerprint(rhs), fingerprint(dict(parameters)) if parameters else None
        place = _place((*held, len(start), sampled, sign))
        if not place:
            place.append(_made(*given))
        found = place[0]
    except Changeable:
        found = _made(*given)
    return found if isinstance(found, Engine) else _called(*given, found)


@lru_cache(maxsize=256)
def _place(key: Hashable) -> list[Any]:
    """Where the engine is kept that was made for this key, or why there is none."""
    return []


def _rates(rhs: Callable[..., Any], parameters: Mapping[str, Any] | None, sign: float) -> Rates:
    rates = bound(rhs, parameters)
    return rates if sign > 0 else reversed_rates(rates)


def _made(
    rhs: Callable[..., Any],
    parameters: Mapping[str, Any] | None,
    times: Array,
    start: Array,
    sampled: bool,
    sign: float,
) -> Engine | str:
    """The engine of a traced right-hand side; or why it is not traced."""
    rates = _rates(rhs, parameters, sign)
    check_start(rates, float(times[0]), start, sign)
    try:
        graph = traced(rates, len(start))
    except Untraceable as reason:
        return str(reason)
    formulas, constants = written(graph)
    found = Engine(rates, _functions(formulas, sampled), constants, formulas, graph, sign=sign)
    if agrees(rates, found.functions["rhs"], constants, times, start):
        return found
    return "its formulas as traced give other numbers than it does"


def _called(
    rhs: Callable[..., Any],
    parameters: Mapping[str, Any] | None,
    times: Array,
    start: Array,
    sampled: bool,
    sign: float,
    why: str,
) -> Engine:
    rates = _rates(rhs, parameters, sign)
    check_start(rates, float(times[0]), start, sign)
    given = floats_function(rates, float(times[0]), start)
    formulas = call_of(len(start))
    return Engine(rates, _with_loop(compiled(formulas, sampled, given)), (), formulas, None, why, sign)


@lru_cache(maxsize=256)
def _functions(formulas: Formulas, sampled: bool) -> dict[str, Any]:
    return _with_loop(compiled(formulas, sampled))


def _with_loop(functions: dict[str, Any]) -> dict[str, Any]:
    """The generated functions and the loop around them."""
    first_step = first_step_with(functions["rhs"], functions["euler"])
    advance = loop_with(*(functions[name] for name in ("raised", "step", "dense", "at")))
    return {**functions, "first_step": first_step, "advance": advance}
