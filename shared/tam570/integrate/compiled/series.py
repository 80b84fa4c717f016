"""Writes LLVM functions that compute the Taylor coefficients of the state, for one motion or for eight at once.

The products of series need sums over earlier coefficients. For eight motions, a loop adds up vectors of eight motions.
For one motion, a vector register accumulates the sums of the next orders: once x_m is computed, x_m y_1, x_m y_2, ...
are terms of the sums of orders m + 1, m + 2, ..., so one product of x_m with the first coefficients of y updates all of
them; each order shifts the register by one element. No sum runs across a register. The lower of the two orders in a
product is at most eight, because the highest order of a sum is seventeen.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache, partial
from typing import NamedTuple

from tam570.integrate.compiled.ir import Value, Writer, number
from tam570.integrate.compiled.llvm import assembled, register_width
from tam570.integrate.compiled.recurrences import Recurrence, Recurrences
from tam570.integrate.dop853 import REACH
from tam570.integrate.formulas import SATURATING, UNIT_ROUNDOFF

LANES = 8
HIGHEST = 2 * LANES + 2  # highest order: the lower order in a product is then at most LANES
FAST = "nsz reassoc contract"  # fast-math flags: sums of products in any order

UNDIVIDED = ("*", "square", "/", "sqrt")  # rules whose sums are not divided by n

Factor = tuple[int, bool]  # a series, and whether its coefficients are multiplied by their order


def vector_width(size: int) -> int:
    """Return how many components of one motion share a vector."""
    return 1 if size == 1 else 2 if size == 2 else 4 if size <= 4 else 8


def padded_size(size: int) -> int:
    """Return the number of components, rounded up to whole vectors."""
    return -(-size // vector_width(size)) * vector_width(size)


@dataclass(frozen=True)
class Layout:
    """Memory layout of the coefficients: strides `across` between rows and `along` between orders, in doubles.

    The first rows are the components of the state; the others are factors of the sums.
    """

    lanes: int
    across: int
    along: int
    rows: dict[Factor, int]
    doubles: int


def strides(size: int, lanes: int) -> tuple[int, int]:
    """Return the strides `across` and `along` of a layout."""
    return (1, padded_size(size)) if lanes == 1 else ((HIGHEST + 1) * lanes, lanes)


class Order(NamedTuple):
    """An order: n as an index, n and 1/n as scalars or vectors, and the flag n == 3, empty if n is never 3."""

    n: str
    number: str
    inverse: str
    is_third: str = ""


def sums_of(series: int, r: Recurrence) -> list[tuple[Factor, Factor]]:
    """Return the sums over j = 1 ... n - 1 of x_j y_(n - j) that a recurrence needs."""
    of = r.of
    if r.rule in ("*", "square"):
        return [((of[0], False), (of[-1], False))]
    if r.rule in ("/", "sqrt"):
        return [((series, False), (of[1] if r.rule == "/" else series, False))]
    if r.rule == "pow":
        return [((of[0], True), (series, False)), ((series, True), (of[0], False))]
    if r.rule == "wy'=ab'-ba'":
        return [((of[1], True), (of[2], False)), ((of[2], True), (of[1], False)), ((series, True), (of[0], False))]
    if r.rule[0] == "w":
        return [((series, True), (of[0], False))]
    return [((of[1], True), (of[0], False))] if r.rule[0] == "y" else []


class Coefficients(Writer):
    """Writes the coefficients; the subclasses differ in how they compute the sums."""

    def __init__(self, laws: Recurrences, memory_layout: Layout) -> None:
        super().__init__()
        self.laws, self.memory_layout = laws, memory_layout
        self.ir_type = "double" if memory_layout.lanes == 1 else f"<{memory_layout.lanes} x double>"
        self.suffix = "f64" if memory_layout.lanes == 1 else f"v{memory_layout.lanes}f64"
        self.first: dict[int, str] = {}  # coefficients of order 0, and the constants
        self.now: dict[int, str] = {}  # coefficients of the current order

    # Instructions on scalars or vectors

    def op(self, name: str, a: str, b: str) -> str:
        return self.emit(self.ir_type, f"f{name} {FAST} {self.ir_type} {a}, {b}").text

    def negative(self, a: str) -> str:
        return self.emit(self.ir_type, f"fneg {self.ir_type} {a}").text

    def constant(self, value: float) -> str:
        return self.each(number(value))

    def each(self, value: str) -> str:
        """Return the scalar, broadcast to all lanes."""
        return value if self.memory_layout.lanes == 1 else self.spread(Value("double", value), self.ir_type)

    def address(self, row: int, index: str | int) -> str:
        """Return the address of the coefficient of order `index` in a row."""
        start = self.element("%work", row * self.memory_layout.across)
        step = f"mul i64 {index}, {self.memory_layout.along}"
        return self.emit("ptr", f"getelementptr double, ptr {start}, i64 {self.emit('i64', step).text}").text

    def keep(self, row: int, index: str | int, value: str) -> None:
        self.do(f"store {self.ir_type} {value}, ptr {self.address(row, index)}, align 8")

    def fetch(self, row: int, index: str | int) -> str:
        return self.emit(self.ir_type, f"load {self.ir_type}, ptr {self.address(row, index)}, align 8").text

    def intrinsic(self, name: str, *arguments: str) -> str:
        """Return the result of LLVM's function of this name on scalars or vectors."""
        listed = ", ".join(f"{self.ir_type} {a}" for a in arguments)
        return self.emit(self.ir_type, f"call {self.ir_type} @llvm.{name}.{self.suffix}({listed})").text

    def function(self, name: str, arguments: list[str]) -> str:
        """Return name(*arguments), lane by lane."""
        if name == "sqrt":
            return self.intrinsic("sqrt", *arguments)

        def call(numbers: list[str]) -> str:  # marked as pure, so that LLVM can merge sin and cos of a number
            listed = ", ".join(f"double {x}" for x in numbers)
            return self.emit("double", f"call double @{name}({listed}) memory(none)").text

        if self.memory_layout.lanes == 1:
            return call(arguments)
        vector = "poison"
        for lane in range(self.memory_layout.lanes):
            parts = [self.emit("double", f"extractelement {self.ir_type} {a}, i32 {lane}").text for a in arguments]
            single = call(parts)
            vector = self.emit(self.ir_type, f"insertelement {self.ir_type} {vector}, double {single}, i32 {lane}").text
        return vector

    # Order 0

    def values(self) -> None:
        """Write the coefficients of order 0, from the time and the state in memory."""
        for i in range(self.laws.constants):
            pointer = self.element("%c", i)
            self.first[-1 - i] = self.each(self.emit("double", f"load double, ptr {pointer}").text)
        for i, r in enumerate(self.laws.series):
            self.first[i] = self.value(r)

    def value(self, r: Recurrence) -> str:
        if r.rule == "time":
            return self.emit(self.ir_type, f"load {self.ir_type}, ptr %t, align 8").text
        if r.rule == "state":
            return self.fetch(r.of[0], 0)
        values_of = [self.first[i] for i in (r.arguments if r.value else r.of)]
        if r.value:
            return self.function(r.value, values_of)
        if r.rule == "neg":
            return self.negative(values_of[0])
        name = {"+": "add", "shift": "add", "-": "sub", "/": "div"}.get(r.rule, "mul")
        return self.op(name, values_of[0], values_of[-1])

    def size(self, a: str) -> str:
        return self.intrinsic("fabs", a)

    def bounds(self) -> dict[int, str]:
        """Return running error bounds of the coefficients of order 0: propagated bounds plus new rounding errors."""
        zero = self.constant(0.0)
        bounds = dict.fromkeys(range(-self.laws.constants, 0), zero)
        for i, r in enumerate(self.laws.series):
            bound = zero
            if r.rule != "neg":
                roundoff = self.constant(2 * UNIT_ROUNDOFF if r.value else UNIT_ROUNDOFF)
                bound = self.op("mul", roundoff, self.size(self.first[i]))
            for factor, j in self.sensitivities(i, r):
                part = bounds[j] if not factor else self.op("mul", factor, bounds[j])
                bound = self.op("add", bound, part)
            bounds[i] = bound
        return bounds

    def sensitivities(self, i: int, r: Recurrence) -> list[tuple[str, int]]:
        """Return the absolute partial derivatives by the operands, as (factor, index); "" is the factor 1."""
        if r.rule in ("time", "state"):
            return []
        y, values_of = self.size(self.first[i]), [self.size(self.first[j]) for j in r.of]
        if r.rule in ("+", "-", "neg", "shift"):
            return [("", j) for j in r.of]
        if r.rule in ("*", "scale", "square"):
            return [(values_of[-1], r.of[0]), (values_of[0], r.of[-1])]
        if r.rule == "/":
            return [
                (self.op("div", self.constant(1.0), values_of[1]), r.of[0]),
                (self.op("div", y, values_of[1]), r.of[1]),
            ]
        if r.rule == "sqrt":
            return [(self.op("div", self.constant(0.5), y), r.of[0])]
        if r.rule == "pow":
            return [(self.op("div", self.op("mul", values_of[1], y), values_of[0]), r.of[0])]
        if r.rule == "wy'=ab'-ba'":
            return [
                (self.op("div", values_of[2], values_of[0]), r.of[1]),
                (self.op("div", values_of[1], values_of[0]), r.of[2]),
            ]
        if r.rule[0] == "w":
            return [(self.op("div", self.constant(1.0), values_of[0]), r.of[1])]
        if "y^2" in r.rule:
            return [(self.op("add", self.constant(1.0), values_of[0]), r.of[1])]
        return [(values_of[0], r.of[1])]

    # Order n

    def all_orders(self, slots: list[str]) -> None:
        """Write the coefficients of orders 1 up to, but not including, %order."""
        raise NotImplementedError

    def coefficient(self, i: int, r: Recurrence, earlier: str) -> str:
        """Return the coefficient of order n: the part from earlier orders, plus multiples of others of order n."""
        of = [self.now.get(j, "") for j in r.of]  # a series that follows has none yet, and its rule needs none
        if r.rule in ("+", "-"):
            return self.op("add" if r.rule == "+" else "sub", of[0], of[1])
        if r.rule == "neg":
            return self.negative(of[0])
        if r.rule == "shift":
            return of[0]
        if r.rule == "/" and r.of[0] < 0:  # constant / series: dividing by its square could underflow
            product = self.op("mul", self.first[i], of[1])
            earlier = self.op("add", earlier, product) if earlier else product
        if earlier and i in self.scales:
            earlier = self.op("mul", earlier, self.scales[i])
        for pointer, factor in self.multiples[i]:
            if r.of[pointer] >= 0:  # constants have no coefficients beyond order 0
                product = self.op("mul", of[pointer], factor)
                earlier = self.op("add", earlier, product) if earlier else product
        return earlier

    def earlier(self, r: Recurrence, sums: list[str]) -> str:
        """Return the part of a coefficient from earlier orders, before scaling and division by n."""
        if r.rule == "pow":
            return self.op("sub", self.op("mul", self.first[r.of[1]], sums[0]), sums[1])
        if r.rule == "wy'=ab'-ba'":
            return self.op("sub", self.op("sub", sums[0], sums[1]), sums[2])
        return sums[0] if sums else ""

    def quotients(self, values: list[str], order: Order) -> list[str]:
        """Return the values divided by n: by multiplication with 1/n, except for n = 3.

        The rounding error of 1/n is the same at every step, so the energy drifts. Nearly all of it comes from n = 3:
        1/2 and 1/4 are exact, and later orders are small. Dividing at all orders would take a seventh of the run time.
        """
        products = [self.op("mul", value, order.inverse) for value in values]
        if not order.is_third:
            return products
        product, third, after = self.labels("product", "third", "after")
        self.jump(product)
        self.start(product)
        self.do(f"br i1 {order.is_third}, label %{third}, label %{after}, !prof !0")  # else LLVM divides at all orders
        self.start(third)
        thirds = [self.op("div", value, self.constant(3.0)) for value in values]
        self.jump(after)
        self.start(after)
        return [
            self.emit(self.ir_type, f"phi {self.ir_type} [{a}, %{product}], [{b}, %{third}]").text
            for a, b in zip(products, thirds, strict=True)
        ]

    def prepared(self) -> None:
        """Write the factors that do not depend on the order: of other coefficients, and of the sums."""
        single = self.constant(1.0)
        self.multiples: dict[int, list[tuple[int, str]]] = {}
        self.scales: dict[int, str] = {}
        for i, r in enumerate(self.laws.series):
            start = [self.first.get(j, "") for j in r.of]
            if r.rule == "scale":
                self.multiples[i] = [(0, start[1])]
            elif r.rule == "*":
                self.multiples[i] = [(1, start[0]), (0, start[1])]
            elif r.rule == "square":
                self.multiples[i] = [(0, self.op("add", start[0], start[0]))]
            elif r.rule in ("/", "sqrt", "pow") or r.rule[0] == "w":
                self._divided(i, r, start, single)
            elif r.rule[0] == "y":
                if r.rule in ("y'=-wa'", "y'=a'-y^2a'"):
                    self.scales[i] = self.constant(-1.0)
                factor = self.negative(start[0]) if i in self.scales else start[0]
                self.multiples[i] = [(1, self.op("add", single, factor) if "y^2" in r.rule else factor)]

    def _divided(self, i: int, r: Recurrence, start: list[str], single: str) -> None:
        divisor = {"/": start[-1], "sqrt": self.op("add", self.first[i], self.first[i])}.get(r.rule, start[0])
        inverse = self.op("div", single, divisor)
        minus = self.negative(inverse)
        self.scales[i] = minus
        if r.rule == "/" and r.of[0] >= 0:
            self.multiples[i] = [(0, inverse), (1, self.op("mul", self.first[i], minus))]
        elif r.rule in ("/", "sqrt"):
            self.multiples[i] = [(0, inverse)]
        elif r.rule == "pow":
            self.scales[i] = inverse
            self.multiples[i] = [(0, self.op("mul", self.op("mul", start[1], self.first[i]), inverse))]
        elif r.rule == "wy'=ab'-ba'":
            self.scales[i] = inverse
            self.multiples[i] = [(1, self.op("mul", start[2], inverse)), (2, self.op("mul", start[1], minus))]
        else:
            self.multiples[i] = [(1, minus if r.rule == "wy'=-a'" else inverse)]

    def loads(self, slots: list[str]) -> list[str]:
        return [self.emit(self.ir_type, f"load {self.ir_type}, ptr {slot}").text for slot in slots]

    def states(self, order: Order, values: list[str]) -> None:
        """Store the state's coefficients of an order."""
        for i, r in enumerate(self.laws.series):
            if r.rule == "state":
                self.now[i] = values[r.of[0]]
                self.keep(r.of[0], order.n, self.now[i])

    def orders(self, order: Order, slots: list[str], sums: list[list[str]]) -> None:
        """Write all coefficients of order n; those of the state are the rates' of order n - 1 over n."""
        zero = self.constant(0.0)
        self.now = dict.fromkeys(range(-self.laws.constants, 0), zero)
        earlier = [self.earlier(r, own_sums) for r, own_sums in zip(self.laws.series, sums, strict=True)]
        divided = [i for i, r in enumerate(self.laws.series) if earlier[i] and r.rule not in UNDIVIDED]
        values = self.quotients([*self.loads(slots), *(earlier[i] for i in divided)], order)
        self.states(order, values[: len(slots)])
        for i, value in zip(divided, values[len(slots) :], strict=True):
            earlier[i] = value
        for i, r in enumerate(self.laws.series):
            if r.rule == "time":
                first = self.emit("i1", f"icmp eq i64 {order.n}, 1").text
                self.now[i] = self.each(self.emit("double", f"select i1 {first}, double 1.0, double 0.0").text)
            elif r.rule != "state":
                self.now[i] = self.coefficient(i, r, earlier[i])
        for slot, rate in zip(slots, self.laws.rates, strict=True):
            self.do(f"store {self.ir_type} {self.now[rate]}, ptr {slot}")

    def reach(self, slots: list[str], exponents: list[int]) -> str:
        """Return the longest step in which each exponent changes by at most half of itself or REACH."""
        single = self.constant(1.0)
        sums = [[self.constant(0.0)] * len(sums_of(i, r)) for i, r in enumerate(self.laws.series)]
        self.orders(Order("1", single, single), slots, sums)
        longest = self.constant(math.inf)
        for i in exponents:
            half = self.op("mul", self.constant(0.5), self.size(self.first[i]))
            allowed = self.intrinsic("maxnum", half, self.constant(REACH))
            longest = self.intrinsic("minnum", longest, self.op("div", allowed, self.size(self.now[i])))
        return longest

    def order(self, n: str, *, may_be_third: bool) -> Order:
        exact = self.emit("double", f"sitofp i64 {n} to double").text
        inverse = self.emit("double", f"fdiv double 1.0, {exact}").text
        is_third = self.emit("i1", f"icmp eq i64 {n}, 3").text if may_be_third else ""
        return Order(n, self.each(exact), self.each(inverse), is_third)

    def loop(self, first: int, end: str, body: Callable[[str], None]) -> None:
        """Write a loop of body(n) over first <= n < end."""
        before, test, body_label, last, after = self.labels("before", "test", "inside", "last", "after")
        n, more = f"%n{self.count}", f"%more{self.count}"
        self.jump(before)
        self.start(before)
        self.jump(test)
        self.start(test)
        self.lines.append(f"  {n} = phi i64 [{first}, %{before}], [{more}, %{last}]")
        self.branch(self.emit("i1", f"icmp slt i64 {n}, {end}"), body_label, after)
        self.start(body_label)
        body(n)
        self.jump(last)
        self.start(last)
        self.lines.append(f"  {more} = add i64 {n}, 1")
        self.jump(test)
        self.start(after)


TOGETHER = {8: 14, 4: 6}  # register width: sums in one loop, each of which takes one register or two


class OfEight(Coefficients):
    """Writes the coefficients of eight motions; the factors of the sums are in memory."""

    def all_orders(self, slots: list[str]) -> None:
        self.loop(1, "%order", lambda n: self._order(n, slots))

    def _order(self, n: str, slots: list[str]) -> None:
        listed, some = [sums_of(i, r) for i, r in enumerate(self.laws.series)], TOGETHER[register_width()]
        flat = [pair for pairs in listed for pair in pairs]
        laws = [total for k in range(0, len(flat), some) for total in self.totals(flat[k : k + some], n)]
        order = self.order(n, may_be_third=True)
        self.orders(order, slots, [[laws.pop(0) for _ in pairs] for pairs in listed])
        for (i, sloped), row in self.memory_layout.rows.items():
            if sloped or self.laws.series[i].rule != "state":
                self.keep(row, n, self.op("mul", order.number, self.now[i]) if sloped else self.now[i])

    def totals(self, pairs: list[tuple[Factor, Factor]], n: str) -> list[str]:
        """Return the sums of products of each pair, computed in one loop over the terms."""
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


FEW = 3  # sums that fit into registers together with the rest of a step


class OfOne(Coefficients):
    """Writes the coefficients of one motion; the sums of the next eight orders fill one register or two, its parts.

    The code skips a part if it is still zero, or if no later order needs it. With more than FEW sums, every part has a
    separate block: in a long block LLVM keeps values in registers that it needs much later.
    """

    def all_orders(self, slots: list[str]) -> None:
        self.width = register_width()
        self.vector, self.parts = f"<{self.width} x double>", range(LANES // self.width)
        self.pairs = [[(min(pair), max(pair)) for pair in sums_of(i, r)] for i, r in enumerate(self.laws.series)]
        factors = {factor: None for pairs in self.pairs for pair in pairs for factor in pair}
        self.ahead = {pair: self._slots() for pairs in self.pairs for pair in pairs}
        self.early = {factor: self._slots() for factor in factors}  # orders 1 to 8
        for first, end, is_early in ((1, LANES + 1, True), (LANES + 1, HIGHEST, False)):
            limit = self.emit("i64", f"call i64 @llvm.smin.i64(i64 %order, i64 {end})").text
            self.loop(first, limit, partial(self._order, slots, is_early))

    def _slots(self) -> list[str]:
        slots = [self.allocated(self.vector).text for _ in self.parts]
        for slot in slots:
            self.do(f"store {self.vector} zeroinitializer, ptr {slot}")
        return slots

    def _load(self, slot: str) -> str:
        return self.emit(self.vector, f"load {self.vector}, ptr {slot}").text

    def _order(self, slots: list[str], is_early: bool, n: str) -> None:
        order = self.order(n, may_be_third=is_early)
        totals = {}
        for pair, parts in self.ahead.items():
            totals[pair] = self.emit("double", f"extractelement {self.vector} {self._load(parts[0])}, i32 0").text
        self.orders(order, slots, [[totals[pair] for pair in pairs] for pairs in self.pairs])
        now = {}
        for i, sloped in self.early:
            now[i, sloped] = self.op("mul", order.number, self.now[i]) if sloped else self.now[i]
        for part in self.parts:
            if is_early and not part and len(self.ahead) <= FEW:
                self._add(now, part, n)
                continue
            needed, after = self.labels("needed", "after")
            first = self.emit("i64", f"add i64 {n}, {self.width * part + 1}").text
            test = f"icmp sgt i64 {n}, {self.width * part}" if is_early and part else f"icmp slt i64 {first}, %order"
            self.branch(self.emit("i1", test), needed, after)
            self.start(needed)
            self._add(now, part, n if is_early else "")
            self.jump(after)
            self.start(after)

    def _add(self, now: dict[Factor, str], part: int, n: str) -> None:
        """Add products with the coefficients of order n to the sums of later orders; n : empty beyond order LANES."""
        lanes, onward = f"<{self.width} x i64>", ", ".join(f"i32 {k}" for k in range(1, self.width + 1))
        if n:
            counted = ", ".join(f"i64 {self.width * part + k}" for k in range(1, self.width + 1))
            wide_n = self.spread(Value("i64", n), lanes)
            is_now = self.emit(f"<{self.width} x i1>", f"icmp eq {lanes} {wide_n}, <{counted}>").text
        wide, before, early = dict[Factor, str](), dict[Factor, str](), dict[Factor, str]()
        for (x, y), parts in self.ahead.items():
            for factor in (x, y):  # load just before use: LLVM keeps this order, and registers are few
                if factor in wide:
                    continue
                wide[factor] = self.spread(Value("double", now[factor]), self.vector)
                before[factor] = early[factor] = self._load(self.early[factor][part])
                if n:
                    both = f"{self.vector} {wide[factor]}, {self.vector} {before[factor]}"
                    early[factor] = self.emit(self.vector, f"select <{self.width} x i1> {is_now}, {both}").text
                    self.do(f"store {self.vector} {early[factor]}, ptr {self.early[factor][part]}")
            later = "zeroinitializer" if parts[part] == parts[-1] else self._load(parts[part + 1])
            both = f"{self.vector} {self._load(parts[part])}, {self.vector} {later}"
            ahead = self.emit(self.vector, f"shufflevector {both}, <{self.width} x i32> <{onward}>").text
            for a, b in ((wide[x], early[y]), (wide[y], before[x])):
                product = self.emit(self.vector, f"fmul {FAST} {self.vector} {a}, {b}").text
                ahead = self.emit(self.vector, f"fadd {FAST} {self.vector} {ahead}, {product}").text
            self.do(f"store {self.vector} {ahead}, ptr {parts[part]}")


@lru_cache(maxsize=256)
def layout(laws: Recurrences, lanes: int) -> Layout:
    """Return the layout: rows for the state; with several lanes, also for the factors of the sums."""
    states = {r.of[0]: i for i, r in enumerate(laws.series) if r.rule == "state"}
    rows: dict[Factor, int] = {(states[component], False): component for component in sorted(states)}
    factors = [factor for i, r in enumerate(laws.series) for pair in sums_of(i, r) for factor in pair]
    for factor in factors if lanes > 1 else []:
        rows.setdefault(factor, len(rows))
    across, along = strides(len(laws.rates), lanes)
    return Layout(lanes, across, along, rows, (HIGHEST + 1) * along if lanes == 1 else max(1, len(rows)) * across)


def series_module(laws: Recurrences, lanes: int) -> str:
    """Return functions of (work, constants, time, order): `coefficients`, `rates`, `roundoff`, and perhaps `reach`."""
    memory_layout, sums_class = layout(laws, lanes), OfOne if lanes == 1 else OfEight
    names = ["coefficients", "rates", "roundoff", *(["reach"] if exponents(laws) else [])]
    seldom = '!0 = !{!"branch_weights", i32 1, i32 1000}'
    return assembled([*(line for name in names for line in _written(sums_class(laws, memory_layout), name)), seldom])


@lru_cache(maxsize=256)
def exponents(laws: Recurrences) -> list[int]:
    """Return the series that are arguments of exp, tanh and similar functions and depend on the state."""
    moving = set[int]()
    for i, r in enumerate(laws.series):
        if r.rule == "state" or moving & {*r.of, *r.arguments}:
            moving.add(i)
    return sorted({r.of[1] for r in laws.series if r.value in SATURATING} & moving)


def _written(series: Coefficients, name: str) -> list[str]:
    """Write a function that stores its result in `work`.

    "coefficients": the state's, up to %order. "rates": those of order 1. "roundoff": bounds of their rounding errors,
    in the same place. "reach": the longest step for arguments of exp and similar functions, in place of the first rate.
    """
    series.values()
    if name in ("coefficients", "reach"):
        slots = [series.allocated(series.ir_type).text for _ in series.laws.rates]
        for slot, rate in zip(slots, series.laws.rates, strict=True):
            series.do(f"store {series.ir_type} {series.first[rate]}, ptr {slot}")
        series.prepared()
        if name == "coefficients":
            series.all_orders(slots)
            last = series.order("%order", may_be_third=False)
            series.states(last, series.quotients(series.loads(slots), last))
        else:
            series.keep(0, 1, series.reach(slots, exponents(series.laws)))
    else:
        values = series.first if name == "rates" else series.bounds()
        for component, rate in enumerate(series.laws.rates):
            series.keep(component, 1, values[rate])
    signature = f"define void @{name}(ptr %work, ptr %c, ptr %t, i64 %order) alignstack(64) {{"
    return [signature, "entry:", *series.allocations, *series.lines, "  ret void", "}"]
