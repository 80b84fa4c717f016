"""From a right-hand side to the functions that step it: traced where it can be, else called as it stands.

What was traced is kept for the next run of a right-hand side with the same fingerprint: it was compared with the
student's function then, and nothing that it depends on has changed since.
"""

from collections.abc import Callable, Hashable, Mapping
from dataclasses import dataclass, field
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


@dataclass(frozen=True)
class _Recipe:
    """What an engine is made of; two with the same key make the same."""

    key: Hashable
    rhs: Callable[..., Any] = field(compare=False)
    parameters: Mapping[str, Any] | None = field(compare=False)
    times: Array = field(compare=False)
    start: Array = field(compare=False)
    sampled: bool = field(compare=False)
    sign: float = field(compare=False)

    @property
    def rates(self) -> Rates:
        rates = bound(self.rhs, self.parameters)
        return rates if self.sign > 0 else reversed_rates(rates)


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
        found = _kept(_Recipe((*held, len(start), sampled, sign), *given))
    except Changeable:
        found = _made(_Recipe(None, *given))
    return found if isinstance(found, Engine) else _called(_Recipe(None, *given), found)


def _made(recipe: _Recipe) -> Engine | str:
    """The engine of a traced right-hand side; or why it is not traced."""
    rates, start = recipe.rates, recipe.start
    check_start(rates, float(recipe.times[0]), start, recipe.sign)
    try:
        graph = traced(rates, len(start))
    except Untraceable as reason:
        return str(reason)
    formulas, constants = written(graph)
    found = Engine(rates, _functions(formulas, recipe.sampled), constants, formulas, graph, sign=recipe.sign)
    if agrees(rates, found.functions["rhs"], constants, recipe.times, start):
        return found
    return "its formulas as traced give other numbers than it does"


_kept = lru_cache(maxsize=256)(_made)


def _called(recipe: _Recipe, why: str) -> Engine:
    rates, start = recipe.rates, recipe.start
    check_start(rates, float(recipe.times[0]), start, recipe.sign)
    given = floats_function(rates, float(recipe.times[0]), start)
    formulas = call_of(len(start))
    return Engine(rates, _with_loop(compiled(formulas, recipe.sampled, given)), (), formulas, None, why, recipe.sign)


@lru_cache(maxsize=256)
def _functions(formulas: Formulas, sampled: bool) -> dict[str, Any]:
    return _with_loop(compiled(formulas, sampled))


def _with_loop(functions: dict[str, Any]) -> dict[str, Any]:
    """The generated functions and the loop around them."""
    first_step = first_step_with(functions["rhs"], functions["euler"])
    advance = loop_with(*(functions[name] for name in ("raised", "step", "dense", "at")))
    return {**functions, "first_step": first_step, "advance": advance}
