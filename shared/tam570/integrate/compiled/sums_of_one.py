"""Sums over earlier coefficients of one motion: each sum is a register with what is known of it for the next orders.

Once x_m is there, x_m y_1, x_m y_2, ... are parts of the sums of the orders m + 1, m + 2, ...: a register of these
takes one product with the first coefficients of y, and moves on by one number an order. Nothing is summed across a
register. One of two factors has an order of eight at most, for the highest order of a sum is seventeen.
"""

from functools import partial

from tam570.integrate.compiled.coefficients import FAST, HIGHEST, LANES, Coefficients, Factor, sums_of
from tam570.integrate.compiled.ir import Value

__all__ = ["OfOne"]

VECTOR = f"<{LANES} x double>"
ONWARD = f"<{LANES} x i32> <{', '.join(f'i32 {k}' for k in range(1, LANES + 1))}>"


class OfOne(Coefficients):
    """One motion."""

    def all_orders(self, slots: list[str]) -> None:
        self.pairs = [[(min(pair), max(pair)) for pair in sums_of(i, r)] for i, r in enumerate(self.laws.series)]
        factors = {factor: None for pairs in self.pairs for pair in pairs for factor in pair}
        self.ahead = {pair: self._slot() for pairs in self.pairs for pair in pairs}
        self.early = {factor: self._slot() for factor in factors}  # orders 1 to 8
        for first, end, is_early in ((1, LANES + 1, True), (LANES + 1, HIGHEST, False)):
            limit = self.emit("i64", f"call i64 @llvm.smin.i64(i64 %order, i64 {end})").text
            self.loop(first, limit, partial(self._order, slots, is_early))

    def _slot(self) -> str:
        slot = self.allocated(VECTOR).text
        self.do(f"store {VECTOR} zeroinitializer, ptr {slot}")
        return slot

    def _load(self, slot: str) -> str:
        return self.emit(VECTOR, f"load {VECTOR}, ptr {slot}").text

    def _order(self, slots: list[str], is_early: bool, n: str) -> None:
        numbers = self.numbers(n)
        totals = {}
        for pair, slot in self.ahead.items():
            totals[pair] = self.emit("double", f"extractelement {VECTOR} {self._load(slot)}, i32 0").text
        self.orders(n, slots, [[totals[pair] for pair in pairs] for pairs in self.pairs], numbers)
        wide = {}
        for i, sloped in self.early:
            wide[i, sloped] = self._wide("double", self.op("mul", numbers[0], self.now[i]) if sloped else self.now[i])
        before = {factor: self._load(slot) for factor, slot in self.early.items()}
        early = self._with(n, wide, before) if is_early else before
        for (x, y), slot in self.ahead.items():
            moved = f"shufflevector {VECTOR} {self._load(slot)}, {VECTOR} zeroinitializer, {ONWARD}"
            ahead = self.emit(VECTOR, moved).text
            for a, b in ((wide[x], early[y]), (wide[y], before[x])):
                product = self.emit(VECTOR, f"fmul {FAST} {VECTOR} {a}, {b}").text
                ahead = self.emit(VECTOR, f"fadd {FAST} {VECTOR} {ahead}, {product}").text
            self.do(f"store {VECTOR} {ahead}, ptr {slot}")

    def _with(self, n: str, wide: dict[Factor, str], before: dict[Factor, str]) -> dict[Factor, str]:
        """Return the first coefficients with those of order n, which they keep."""
        lane = self._wide("i64", self.emit("i64", f"sub i64 {n}, 1").text)
        counted = ", ".join(f"i64 {k}" for k in range(LANES))
        is_lane = self.emit(f"<{LANES} x i1>", f"icmp eq <{LANES} x i64> {lane}, <{counted}>").text
        early = {}
        for factor, slot in self.early.items():
            chosen = f"select <{LANES} x i1> {is_lane}, {VECTOR} {wide[factor]}, {VECTOR} {before[factor]}"
            early[factor] = self.emit(VECTOR, chosen).text
            self.do(f"store {VECTOR} {early[factor]}, ptr {slot}")
        return early

    def _wide(self, ir_type: str, value: str) -> str:
        return self.spread(Value(ir_type, value), f"<{LANES} x {ir_type}>")
