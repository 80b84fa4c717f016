"""Sums over earlier coefficients of one motion, with all that they take in registers: for few sums.

A series has two registers of eight doubles, forwards or backwards. The two newest coefficients are added one by one:
to put them into the registers takes time, and the next order need not wait for it.
"""

from functools import partial

from tam570.integrate.compiled.coefficients import FAST, HIGHEST, LANES, Coefficients, Factor, sums_of

__all__ = ["InRegisters"]

VECTOR = f"<{LANES} x double>"


class InRegisters(Coefficients):
    """One motion. Of each factor: order 1, the last two orders, and the register of those before."""

    def all_orders(self, slots: list[str]) -> None:
        listed = [sums_of(i, r) for i, r in enumerate(self.laws.series)]
        self.forward = {x: self._registers() for pairs in listed for x, _ in pairs}
        self.backward = {y: self._registers() for pairs in listed for _, y in pairs}
        factors = {**self.forward, **self.backward}
        self.recent = {factor: [self._slot("double", "0.0") for _ in range(3)] for factor in factors}
        stretches = [(1, LANES + 4, 1), (LANES + 4, HIGHEST, 2)]
        for first, end, registers in stretches:
            limit = self.emit("i64", f"call i64 @llvm.smin.i64(i64 %order, i64 {end})").text
            self.loop(first, limit, partial(self._order, slots, registers))

    def _registers(self) -> list[str]:
        return [self._slot(VECTOR, "zeroinitializer") for _ in range(2)]

    def _slot(self, ir_type: str, value: str) -> str:
        slot = self.allocated(ir_type).text
        self.do(f"store {ir_type} {value}, ptr {slot}")
        return slot

    def _load(self, ir_type: str, slot: str) -> str:
        return self.emit(ir_type, f"load {ir_type}, ptr {slot}").text

    def _order(self, slots: list[str], registers: int, n: str) -> None:
        numbers = self.numbers(n)
        recent = {factor: [self._load("double", p) for p in places] for factor, places in self.recent.items()}
        registers_now = self._gathered(n, recent, registers)
        second = self.emit("i1", f"icmp eq i64 {n}, 2").text
        sums = [
            [
                self._sum(registers_now[0][x], registers_now[1][y], recent[x], recent[y], second)
                for x, y in sums_of(i, r)
            ]
            for i, r in enumerate(self.laws.series)
        ]
        self.orders(n, slots, sums, numbers)
        first = self.emit("i1", f"icmp eq i64 {n}, 1").text
        for (i, sloped), places in self.recent.items():
            value = self.op("mul", numbers[0], self.now[i]) if sloped else self.now[i]
            old = recent[i, sloped]
            single = self.emit("double", f"select i1 {first}, double {value}, double {old[0]}").text
            for new, slot in zip((single, value, old[1]), places, strict=True):
                self.do(f"store double {new}, ptr {slot}")

    def _gathered(self, n: str, recent: dict[Factor, list[str]], registers: int) -> list[dict[Factor, list[str]]]:
        """Return the registers with order n - 2 in its place: x_2, x_3, ... forwards, y_(n - 2), y_(n - 3), ...

        Backwards.
        """
        lane = self.emit("i64", f"sub i64 {n}, 4").text
        masks = [self._mask(lane, k) for k in range(registers)]
        forward: dict[Factor, list[str]] = {}
        backward: dict[Factor, list[str]] = {}
        for x, places in self.forward.items():
            value = self._wide(recent[x][2])
            forward[x] = []
            for mask, slot in zip(masks, places, strict=False):
                old = self._load(VECTOR, slot)
                chosen = f"select <{LANES} x i1> {mask}, {VECTOR} {value}, {VECTOR} {old}"
                forward[x].append(self.emit(VECTOR, chosen).text)
                self.do(f"store {VECTOR} {forward[x][-1]}, ptr {slot}")
        for y, places in self.backward.items():
            newest = self.emit(VECTOR, f"insertelement {VECTOR} poison, double {recent[y][2]}, i32 {LANES - 1}").text
            backward[y] = []
            for slot in places[:registers]:
                old = self._load(VECTOR, slot)
                order = ", ".join(f"i32 {k}" for k in range(LANES - 1, 2 * LANES - 1))
                shifted = f"shufflevector {VECTOR} {newest}, {VECTOR} {old}, <{LANES} x i32> <{order}>"
                backward[y].append(self.emit(VECTOR, shifted).text)
                self.do(f"store {VECTOR} {backward[y][-1]}, ptr {slot}")
                newest = old
        return [forward, backward]

    def _mask(self, lane: str, register: int) -> str:
        ir_type = f"<{LANES} x i64>"
        single = self.emit(ir_type, f"insertelement {ir_type} poison, i64 {lane}, i32 0").text
        all_of = self.emit(
            ir_type, f"shufflevector {ir_type} {single}, {ir_type} poison, <{LANES} x i32> zeroinitializer"
        ).text
        counted = ", ".join(f"i64 {register * LANES + k}" for k in range(LANES))
        return self.emit(f"<{LANES} x i1>", f"icmp eq {ir_type} {all_of}, <{counted}>").text

    def _wide(self, value: str) -> str:
        single = self.emit(VECTOR, f"insertelement {VECTOR} poison, double {value}, i32 0").text
        return self.emit(
            VECTOR, f"shufflevector {VECTOR} {single}, {VECTOR} poison, <{LANES} x i32> zeroinitializer"
        ).text

    def _sum(self, x: list[str], y: list[str], of_x: list[str], of_y: list[str], second: str) -> str:
        """Return the registers' products, and those of orders 1 and n - 1; at n = 2 these are one and the same."""
        total = ""
        for a, b in zip(x, y, strict=True):
            product = self.emit(VECTOR, f"fmul {FAST} {VECTOR} {a}, {b}").text
            total = self.emit(VECTOR, f"fadd {FAST} {VECTOR} {total}, {product}").text if total else product
        inner = f"call {FAST} double @llvm.vector.reduce.fadd.v{LANES}f64(double -0.0, {VECTOR} {total})"
        far = self.emit("double", f"select i1 {second}, double 0.0, double {of_x[1]}").text
        ends = self.op("add", self.op("mul", of_x[0], of_y[1]), self.op("mul", far, of_y[0]))
        return self.op("add", self.emit("double", inner).text, ends)
