"""All Taylor coefficients of the state as functions of LLVM's representation, for one motion or for eight at once."""

from functools import lru_cache

from tam570.integrate.compiled.coefficients import HIGHEST, Coefficients, Factor, Layout, sums_of
from tam570.integrate.compiled.recurrences import Recurrences
from tam570.integrate.compiled.sums_of_eight import OfEight
from tam570.integrate.compiled.sums_of_one import OfOne
from tam570.integrate.compiled.taylor_memory import padded
from tam570.integrate.formulas import SATURATING

__all__ = ["exponents", "layout", "series_text"]


@lru_cache(maxsize=256)
def layout(laws: Recurrences, lanes: int) -> Layout:
    """Rows for the states; with several lanes, also for whatever a sum needs."""
    states = {r.of[0]: i for i, r in enumerate(laws.series) if r.rule == "state"}
    rows: dict[Factor, int] = {(states[component], False): component for component in sorted(states)}
    factors = [factor for i, r in enumerate(laws.series) for pair in sums_of(i, r) for factor in pair]
    for factor in factors if lanes > 1 else []:
        rows.setdefault(factor, len(rows))
    if lanes == 1:
        along = padded(len(laws.rates))
        return Layout(1, 1, along, rows, (HIGHEST + 1) * along)
    return Layout(lanes, (HIGHEST + 1) * lanes, lanes, rows, max(1, len(rows)) * (HIGHEST + 1) * lanes)


def series_text(laws: Recurrences, memory_layout: Layout) -> list[str]:
    """Return the functions `coefficients`, `rates`, `roundoff` of (work, constants, time, order), order 0 in work."""
    sums_class = OfOne if memory_layout.lanes == 1 else OfEight
    names = ["coefficients", "rates", "roundoff", *(["reach"] if exponents(laws) else [])]
    return [line for name in names for line in _written(sums_class(laws, memory_layout), name)]


@lru_cache(maxsize=256)
def exponents(laws: Recurrences) -> list[int]:
    """Return the arguments of exp, tanh and their like that depend on the state."""
    moving = set[int]()
    for i, r in enumerate(laws.series):
        if r.rule == "state" or moving & {*r.of, *r.arguments}:
            moving.add(i)
    return sorted({r.of[1] for r in laws.series if r.value in SATURATING} & moving)


def _written(series: Coefficients, name: str) -> list[str]:
    """Write the coefficients up to %order, or of the state up to order 1 only.

    In their place what rounding does to them; or in the place of the first, the longest step for the arguments of exp
    and its like.
    """
    series.values()
    if name in ("coefficients", "reach"):
        slots = [series.allocated(series.ir_type).text for _ in series.laws.rates]
        for slot, rate in zip(slots, series.laws.rates, strict=True):
            series.do(f"store {series.ir_type} {series.first[rate]}, ptr {slot}")
        series.prepared()
        if name == "coefficients":
            series.all_orders(slots)
            series.states("%order", series.numbers("%order")[1], slots)
        else:
            series.keep(0, 1, series.reach(slots, exponents(series.laws)))
    else:
        values = series.first if name == "rates" else series.bounds()
        for component, rate in enumerate(series.laws.rates):
            series.keep(component, 1, values[rate])
    signature = f"define internal void @{name}(ptr %work, ptr %c, ptr %t, i64 %order) alignstack(64) {{"
    return [signature, "entry:", *series.allocations, *series.lines, "  ret void", "}"]
