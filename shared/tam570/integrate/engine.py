"""Builds the functions that step a right-hand side: from its trace, or by calls if it cannot be traced.

Traced engines are memoized by the key of the right-hand side. Each was compared with the student's function when it was
built; an equal key means that none of its dependencies has changed since.
"""

from bisect import bisect_right
from dataclasses import dataclass
from functools import cache, cached_property, lru_cache

from tam570.integrate.adaptive_loop import GENERATED, loop_with
from tam570.integrate.arguments import Array
from tam570.integrate.breaks import breaks_of
from tam570.integrate.cache_key import Changeable, cache_slot, call_key
from tam570.integrate.dop853 import compiled
from tam570.integrate.formulas import Formulas, call_of, uses_of, written
from tam570.integrate.rates import CalledRates, Rates, bound, check_start, is_same
from tam570.integrate.switches import Switches
from tam570.integrate.trace import EDGES, Graph, Untraceable, traced
from tam570.values import Function, Json, Parameters

KINKED = {"asin", "acos"}  # operations with infinite slope at the edges of their domain


class Mistraced(Exception):
    """Raised if traced formulas have no finite value: the run is then repeated with calls of the right-hand side."""


@dataclass(frozen=True, eq=False)
class Engine:
    """The functions generated for a right-hand side, and the constants in it."""

    rates: Rates  # the right-hand side itself
    functions: Json
    constants: tuple[float, ...]
    formulas: Formulas
    graph: Graph | None  # None if the right-hand side is called
    untraced_reason: str = ""
    sign: float = 1.0  # -1 if the engine's time is -t
    called_rates: CalledRates | None = None
    switches: Switches | None = None

    def begin(self, rtol: float) -> None:
        """Prepare called rates for a new run."""
        if self.called_rates and self.switches:
            self.called_rates.begin(rtol)
            self.switches.begin(rtol)

    @property
    def is_traced(self) -> bool:
        return self.graph is not None

    @cached_property
    def may_have_kinks(self) -> bool:
        return self.graph is None or any(symbol.name in KINKED for symbol in self.graph.operations)

    def next_break(self, t: float, begin: float, end: float) -> float:
        """Return the end of the stretch that starts at t, in a run from begin to end.

        It is the next time at which a step might miss a traced function of time, or `end`.
        """
        if self.graph is None or not self.formulas.timed:
            return end
        breaks = breaks_of(self.graph, begin, end)
        later = bisect_right(breaks, t)
        return breaks[later] if later < len(breaks) else end


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
    """Return the engine of a right-hand side: traced, if the trace reproduces its values, else one that calls it.

    sign    : -1 if the engine's time is -t
    sampled : whether states inside steps are needed even if there are only two times
    may_trace : whether traced formulas may replace calls
    """
    sampled, reason = sampled or len(times) > 2, "its formulas have no value where a step ends"

    @cache
    def tried_rates() -> CalledRates:
        """Return the right-hand side after a check of its values at the start."""
        forward = bound(rhs, parameters)
        rates: Rates = forward if sign > 0 else lambda t, y: [-1.0 * rate for rate in forward(-t, y)]
        called_rates = CalledRates(rates, len(start))
        check_start(forward, sign * float(times[0]), start, 1.0)
        return called_rates

    try:
        slot = cache_slot((call_key(rhs, parameters), len(start), sampled, sign)) if may_trace else [reason]
        if not slot:
            slot.append(_traced_engine(tried_rates().rates, times, start, sampled, sign))
        if isinstance(slot[0], Engine):
            return slot[0]
        reason = slot[0]
    except Changeable as changeable:
        reason = str(changeable)
    return _called_engine(tried_rates(), times, sampled, sign, reason)


def _traced_engine(rates: Rates, times: Array, start: Array, sampled: bool, sign: float) -> Engine | str:
    """Return the engine of a traced right-hand side, or the reason why it cannot be traced."""
    try:
        graph = traced(rates, len(start))
    except Untraceable as reason:
        return str(reason)
    uses = uses_of(graph.operations, graph.rates)
    if any(symbol.name in EDGES and not uses[symbol.number] for symbol in graph.operations):
        return "it computes what it does not use: it may ask whether that exists"
    formulas, constants = written(graph)
    functions = _functions(formulas, sampled)
    if not is_same(rates, functions["rhs"], constants, times, start):
        return "its formulas as traced give other numbers than it does"
    return Engine(rates, functions, constants, formulas, graph, sign=sign)


def _called_engine(called_rates: CalledRates, times: Array, sampled: bool, sign: float, reason: str) -> Engine:
    formulas = call_of(called_rates.size)
    switches = Switches(called_rates, float(times[-1] - times[0]), sign)
    by_call = {"roundoff": called_rates.roundoff, "reach": switches.reach, "passed": switches.passed}
    functions = _with_loop({**compiled(formulas, sampled, called_rates), **by_call})
    return Engine(called_rates.rates, functions, (), formulas, None, reason, sign, called_rates, switches)


@lru_cache(maxsize=256)
def _functions(formulas: Formulas, sampled: bool) -> Json:
    return _with_loop(compiled(formulas, sampled))


def _with_loop(functions: Json) -> Json:
    """Return the generated functions and, as "advance", the loop around them."""
    return {**functions, "advance": loop_with(*(functions[name] for name in GENERATED))}
