"""All Taylor coefficients of the state as functions of LLVM's representation, for one motion or for eight at once."""

from functools import lru_cache

from tam570.integrate.compiled.coefficients import BACK, HIGHEST, LANES, Coefficients, Layout, Row, sums_of
from tam570.integrate.compiled.recurrences import Recurrences
from tam570.integrate.compiled.sums_in_memory import InMemory, OfEight
from tam570.integrate.compiled.sums_in_registers import InRegisters
from tam570.integrate.formulas import SATURATING

__all__ = ["exponents", "layout", "series_text"]

FEW = 8  # sums, so that all that they take stays in registers: a double pendulum has 15 and is slower so


def _sums(laws: Recurrences) -> int:
    return sum(len(sums_of(i, r)) for i, r in enumerate(laws.series))


@lru_cache(maxsize=256)
def layout(laws: Recurrences, lanes: int) -> Layout:
    """Rows for the states and whatever a sum needs."""
    states = {r.of[0]: i for i, r in enumerate(laws.series) if r.rule == "state"}
    rows: dict[Row, int] = {(states[component], False): component for component in sorted(states)}
    for i, r in enumerate(laws.series):
        for x, y in sums_of(i, r):
            rows.setdefault(x, len(rows))
            rows.setdefault(y if lanes > 1 else (y[0], None), len(rows))
    return Layout(lanes, HIGHEST + 1 if lanes > 1 else BACK + 4 * LANES, rows)


def series_text(laws: Recurrences, memory_layout: Layout) -> list[str]:
    """Return the functions `coefficients`, `rates`, `roundoff` of (work, constants, time, order), order 0 in work."""
    single = InRegisters if _sums(laws) <= FEW else InMemory
    sums_class = single if memory_layout.lanes == 1 else OfEight
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
    signature = f"define internal void @{name}(ptr %work, ptr %c, ptr %t, i64 %order) {{"
    return [signature, "entry:", *series.allocations, *series.lines, "  ret void", "}"]
