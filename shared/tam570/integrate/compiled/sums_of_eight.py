"""Sums over earlier coefficients of eight motions at once, from memory: each term is eight numbers."""

from tam570.integrate.compiled.coefficients import FAST, Coefficients, Factor, sums_of

__all__ = ["OfEight"]

TOGETHER = 14  # sums in one loop: each takes a register


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
