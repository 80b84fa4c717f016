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
    backward: bool = field(compare=False)

    @property
    def rates(self) -> Rates:
        rates = bound(self.rhs, self.parameters)
        return reversed_rates(rates) if self.backward else rates

    @property
    def sampled(self) -> bool:
        return len(self.times) > 2


def engine(
    rhs: Callable[..., Any], parameters: Mapping[str, Any] | None, times: Array, start: Array, *, backward: bool = False
) -> Engine:
    """Functions for the right-hand side as traced, if it can be and agrees; else for calls of it.

    backward : the times are those of -t
    """
    try:
        held = fingerprint(rhs), fingerprint(dict(parameters)) if parameters else None
        key = *held, len(start), len(times) > 2, backward
        found = _kept(_Recipe(key, rhs, parameters, times, start, backward))
    except Changeable:
        found = _made(_Recipe(None, rhs, parameters, times, start, backward))
    return (
        found if isinstance(found, Engine) else _called(_Recipe(None, rhs, parameters, times, start, backward), found)
    )


def _made(recipe: _Recipe) -> Engine | str:
    """The engine of a traced right-hand side; or why it is not traced."""
    rates, start = recipe.rates, recipe.start
    check_start(rates, float(recipe.times[0]), start)
    try:
        graph = traced(rates, len(start))
    except Untraceable as reason:
        return str(reason)
    formulas, constants = written(graph)
    found = Engine(rates, _functions(formulas, recipe.sampled), constants, formulas, graph)
    if agrees(rates, found.functions["rhs"], constants, recipe.times, start):
        return found
    return "its formulas as traced give other numbers than it does"


_kept = lru_cache(maxsize=256)(_made)


def _called(recipe: _Recipe, why: str) -> Engine:
    rates, start = recipe.rates, recipe.start
    check_start(rates, float(recipe.times[0]), start)
    given = floats_function(rates, float(recipe.times[0]), start)
    formulas = call_of(len(start))
    return Engine(rates, _with_loop(compiled(formulas, recipe.sampled, given)), (), formulas, None, why)


@lru_cache(maxsize=256)
def _functions(formulas: Formulas, sampled: bool) -> dict[str, Any]:
    return _with_loop(compiled(formulas, sampled))


def _with_loop(functions: dict[str, Any]) -> dict[str, Any]:
    """The generated functions and the loop around them."""
    first_step = first_step_with(functions["rhs"], functions["euler"])
    advance = loop_with(*(functions[name] for name in ("raised", "step", "dense", "at")))
    return {**functions, "first_step": first_step, "advance": advance}
