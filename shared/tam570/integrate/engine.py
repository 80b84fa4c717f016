"""From a right-hand side to the functions that step it: traced where it can be, else called as it stands.

What was traced is kept for the next run of a right-hand side with the same key: it was compared with the student's
function then, and nothing that it depends on has changed since.
"""

from collections.abc import Hashable
from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple

from tam570.integrate.adaptive_loop import GENERATED, first_step_with, loop_with
from tam570.integrate.arguments import Array
from tam570.integrate.breaks import breaks_of
from tam570.integrate.cache_key import Changeable, call_key
from tam570.integrate.dop853 import compiled
from tam570.integrate.formulas import Formulas, call_of, written
from tam570.integrate.rates import (
    CalledRates,
    Rates,
    bound,
    check_start,
    is_same,
    reversed_rates,
    roundoff_by_neighbours,
)
from tam570.integrate.switches import Switches
from tam570.integrate.trace import Graph, Untraceable, traced
from tam570.values import Function, Json, Numbers, Parameters

__all__ = ["Engine", "Mistraced", "engine"]


class Mistraced(Exception):
    """Where the formulas have no value the right-hand side has one: it is to be called as it stands."""


@dataclass(frozen=True, eq=False)
class Engine:
    """The functions generated for a right-hand side, and the constants of its scene."""

    rates: Rates  # the right-hand side itself
    functions: Json
    constants: tuple[float, ...]
    formulas: Formulas
    graph: Graph | None  # None where the right-hand side is called as it stands
    untraced_reason: str = ""
    sign: float = 1.0  # of the clock: -1 where the times are those of -t
    called_rates: CalledRates | None = None
    switches: Switches | None = None

    @property
    def is_traced(self) -> bool:
        return self.graph is not None

    def next_break(self, t: float, begin: float, end: float) -> float:
        """Return where a stretch from t on ends in a run from begin to end.

        Where a traced function of time may be passed, or at `end`.
        """
        if self.graph is None or not self.formulas.timed:
            return end
        return next((time for time in breaks_of(self.graph, begin, end) if time > t), end)


def engine(
    rhs: Function,
    parameters: Parameters | None,
    times: Array,
    start: Array,
    *,
    sign: float = 1.0,
    sampled: bool = False,
    may_trace: bool = True,
) -> Engine:
    """Functions for the right-hand side as traced, if it can be and agrees; else for calls of it.

    sign    : of the clock; -1 where the times are those of -t
    sampled : states inside of steps will be asked for, not only where there are more than two times
    may_trace : whether formulas may take the place of calls
    """
    run = _Run(rhs, parameters, times, start, sampled or len(times) > 2, sign)
    if not may_trace:
        return _called_engine(run, "it has a value where its formulas have none")
    try:
        key = call_key(rhs, parameters)
        slot = _cache_slot((key, len(start), run.sampled, sign))
        if not slot:
            slot.append(_traced_engine(run))
        result = slot[0]
    except Changeable as reason:
        result = str(reason)
    return result if isinstance(result, Engine) else _called_engine(run, result)


@lru_cache(maxsize=256)
def _cache_slot(key: Hashable) -> list[Numbers]:
    """Return where the engine is kept that was made for this key, or why there is none."""
    return []


class _Run(NamedTuple):
    """What an engine is made of."""

    rhs: Function
    parameters: Parameters | None
    times: Array
    start: Array
    sampled: bool
    sign: float

    def rates(self) -> Rates:
        """Return the right-hand side, tried at the start."""
        rates = bound(self.rhs, self.parameters)
        rates = rates if self.sign > 0 else reversed_rates(rates)
        check_start(rates, float(self.times[0]), self.start, self.sign)
        return rates


def _traced_engine(run: _Run) -> Engine | str:
    """Return the engine of a traced right-hand side; or why it is not traced."""
    rates = run.rates()
    try:
        graph = traced(rates, len(run.start))
    except Untraceable as reason:
        return str(reason)
    formulas, constants = written(graph)
    engine = Engine(rates, _functions(formulas, run.sampled), constants, formulas, graph, sign=run.sign)
    if is_same(rates, engine.functions["rhs"], constants, run.times, run.start):
        return engine
    return "its formulas as traced give other numbers than it does"


def _called_engine(run: _Run, reason: str) -> Engine:
    rates = run.rates()
    called_rates = CalledRates(rates, len(run.start))
    formulas = call_of(len(run.start))
    functions = compiled(formulas, run.sampled, called_rates)
    switches = Switches(rates, len(run.start), float(run.times[-1] - run.times[0]), run.sign)
    by_call = {"roundoff": roundoff_by_neighbours(called_rates), "reach": switches.reach, "passed": switches.passed}
    functions = _with_loop({**functions, **by_call})
    return Engine(rates, functions, (), formulas, None, reason, run.sign, called_rates, switches)


@lru_cache(maxsize=256)
def _functions(formulas: Formulas, sampled: bool) -> Json:
    return _with_loop(compiled(formulas, sampled))


def _with_loop(functions: Json) -> Json:
    """Return the generated functions and the loop around them."""
    first_step = first_step_with(functions["rhs"], functions["euler"])
    advance = loop_with(*(functions[name] for name in GENERATED))
    return {**functions, "first_step": first_step, "advance": advance}
