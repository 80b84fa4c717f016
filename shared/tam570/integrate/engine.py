"""From a right-hand side to the functions that step it: traced where it can be, else called as it stands."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

from tam570.integrate.adaptive_loop import first_step_with, loop_with
from tam570.integrate.arguments import Array
from tam570.integrate.binding import agrees, bound, check_start, floats_function
from tam570.integrate.dop853_source import compiled
from tam570.integrate.formulas import Formulas, call_of, written
from tam570.integrate.symbols import Untraceable
from tam570.integrate.trace import Graph, traced

__all__ = ["Engine", "engine"]

Items = tuple[tuple[str, Any], ...]


@dataclass(frozen=True, eq=False)
class Engine:
    """The functions generated for a right-hand side, and the constants of its scene."""

    functions: dict[str, Any]
    constants: tuple[float, ...]
    formulas: Formulas
    graph: Graph | None  # None where the right-hand side is called as it stands
    why: str = ""  # it is not traced

    @property
    def traced(self) -> bool:
        return self.graph is not None


def engine(rhs: Callable[..., Any], parameters: Mapping[str, Any] | None, times: Array, start: Array) -> Engine:
    """Functions for the right-hand side as traced, if it can be and agrees; else for calls of it."""
    rates, sampled = bound(rhs, parameters), len(times) > 2
    check_start(rates, float(times[0]), start)
    try:
        found = _traced(rhs, tuple((parameters or {}).items()), len(start), sampled)
        if agrees(rates, found.functions["rhs"], found.constants, times, start):
            return found
        why = "its formulas as traced give other numbers than it does"
    except Untraceable as reason:
        why = str(reason)
    given = floats_function(rates, float(times[0]), start)
    formulas = call_of(len(start))
    return Engine(_with_loop(compiled(formulas, sampled, given)), (), formulas, None, why)


def _traced(rhs: Callable[..., Any], items: Items, size: int, sampled: bool) -> Engine:
    """The engine of a traced right-hand side, kept for the next run with these very parameters.

    Kept ones are compared with the function again, as all are: what it refers to may have changed.
    """
    try:
        graph, formulas, constants = _graph(rhs, items, size)
    except Untraceable:
        raise
    except TypeError:  # parameters that cannot be told apart by a hash, arrays for one
        graph = traced(bound(rhs, dict(items)), size)
        formulas, constants = written(graph)
    return Engine(_functions(formulas, sampled), constants, formulas, graph)


@lru_cache(maxsize=256)
def _graph(rhs: Any, items: Items, size: int) -> tuple[Graph, Formulas, tuple[float, ...]]:
    graph = traced(bound(rhs, dict(items)), size)
    return graph, *written(graph)


@lru_cache(maxsize=256)
def _functions(formulas: Formulas, sampled: bool) -> dict[str, Any]:
    return _with_loop(compiled(formulas, sampled))


def _with_loop(functions: dict[str, Any]) -> dict[str, Any]:
    """The generated functions and the loop around them."""
    first_step = first_step_with(functions["rhs"], functions["euler"])
    advance = loop_with(*(functions[name] for name in ("raised", "step", "dense", "at")))
    return {**functions, "first_step": first_step, "advance": advance}
