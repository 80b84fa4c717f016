"""Sums over earlier coefficients from memory: of one motion, for many sums, and of eight motions at once.

One motion: eight terms at a time, one series forwards, the other backwards. Eight motions: each term is eight numbers.
"""

from functools import partial

from tam570.integrate.compiled.coefficients import BACK, FAST, HIGHEST, LANES, Coefficients, Factor, sums_of

__all__ = ["InMemory", "OfEight"]

TOGETHER = 14  # sums of eight motions in one loop: each takes a register
VECTOR = f"<{LANES} x double>"
VECTORS = 2  # for the longest sums: the code is written once for up to eight terms and once for more


class InMemory(Coefficients):
    """One motion."""

    def all_orders(self, slots: list[str]) -> None:
        for first, end, vectors in [(1, LANES + 2, 1), (LANES + 2, HIGHEST, VECTORS)]:
            limit = self.emit("i64", f"call i64 @llvm.smin.i64(i64 %order, i64 {end})").text
            self.loop(first, limit, partial(self._order, slots, vectors))

    def _order(self, slots: list[str], vectors: int, n: str) -> None:
        numbers = self.numbers(n)
        back = self.emit("i64", f"sub i64 {BACK + 1}, {n}").text
        listed = [sums_of(i, r) for i, r in enumerate(self.laws.series)]
        sums = [[self._sum(x, y, back, vectors) for x, y in pairs] for pairs in listed]
        self.orders(n, slots, sums, numbers)
        slot = self.emit("i64", f"sub i64 {BACK}, {n}").text
        for (i, way), row in self.memory_layout.rows.items():
            if way is None:
                self.keep(row, slot, self.now[i])
            elif way or row >= len(self.laws.rates):  # the state's are there already
                self.keep(row, n, self.op("mul", numbers[0], self.now[i]) if way else self.now[i])

    def _sum(self, x: Factor, y: Factor, back: str, vectors: int) -> str:
        """Orders 1, 2, ... of the one with n - 1, n - 2, ... of the other; beyond are zeros."""
        total, start = "", self.address(self.memory_layout.rows[y[0], None], back, 1)
        for k in range(vectors):
            x_row, y_row = self.address(self.memory_layout.rows[x], 1 + LANES * k, 1), self.element(start, LANES * k)
            a, b = (self.emit(VECTOR, f"load {VECTOR}, ptr {slot}, align 8").text for slot in (x_row, y_row))
            product = self.emit(VECTOR, f"fmul {FAST} {VECTOR} {a}, {b}").text
            total = self.emit(VECTOR, f"fadd {FAST} {VECTOR} {total}, {product}").text if total else product
        reduced = f"call {FAST} double @llvm.vector.reduce.fadd.v{LANES}f64(double -0.0, {VECTOR} {total})"
        return self.emit("double", reduced).text


class OfEight(Coefficients):
    """Eight motions. The factors are in memory, order by order."""

    def all_orders(self, slots: list[str]) -> None:
        self.loop(1, "%order", lambda n: self._order(n, slots))

    def _order(self, n: str, slots: list[str]) -> None:
        listed = [sums_of(i, r) for i, r in enumerate(self.laws.series)]
        flat = [pair for pairs in listed for pair in pairs]
        laws = [total for k in range(0, len(flat), TOGETHER) for total in self.totals(flat[k : k + TOGETHER], n)]
        sums, numbers = [[laws.pop(0) for _ in pairs] for pairs in listed], self.numbers(n)
        self.orders(n, slots, sums, numbers)
        for (i, sloped), row in self.memory_layout.rows.items():
            if sloped or self.laws.series[i].rule != "state":
                self.keep(row, n, self.op("mul", numbers[0], self.now[i]) if sloped else self.now[i])

    def totals(self, pairs: list[tuple[Factor, Factor]], n: str) -> list[str]:
        """Return sums of eight motions each, in one loop over the terms."""
        before, test, body_label, after = self.labels("before", "test", "inside", "after")
        self.jump(before)
        self.start(before)
        self.jump(test)
        self.start(test)
        j, more = f"%j{self.count}", f"%more{self.count}"
        names = [(f"%sum{self.count}_{k}", f"%next{self.count}_{k}") for k in range(len(pairs))]
        self.lines.append(f"  {j} = phi i64 [1, %{before}], [{more}, %{body_label}]")
        for total, following in names:
            self.lines.append(
                f"  {total} = phi {self.ir_type} [zeroinitializer, %{before}], [{following}, %{body_label}]"
            )
        self.branch(self.emit("i1", f"icmp slt i64 {j}, {n}"), body_label, after)
        self.start(body_label)
        rest = self.emit("i64", f"sub i64 {n}, {j}").text
        xs = {x: self.fetch(self.memory_layout.rows[x], j) for x, _ in pairs}
        ys = {y: self.fetch(self.memory_layout.rows[y], rest) for _, y in pairs}
        for (x, y), (total, following) in zip(pairs, names, strict=True):
            product = self.op("mul", xs[x], ys[y])
            self.lines.append(f"  {following} = fadd {FAST} {self.ir_type} {total}, {product}")
        self.lines.append(f"  {more} = add i64 {j}, 1")
        self.jump(test)
        self.start(after)
        return [total for total, _ in names]
