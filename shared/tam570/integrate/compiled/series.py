"""Recurrences as LLVM's representation: all Taylor coefficients of the state, for one motion or for eight at once.

One motion: a sum over earlier coefficients takes eight of them at a time, one series forwards, the other backwards.
Eight motions: each number is eight numbers, one a motion.
"""

from dataclasses import dataclass
from functools import lru_cache
from math import ceil

from tam570.integrate.compiled.ir import Writer, number
from tam570.integrate.compiled.recurrences import Recurrence, Recurrences

__all__ = ["HIGHEST", "LANES", "Layout", "layout", "series_text"]

LANES = 8
HIGHEST = 2 * LANES + 2  # order: its sums are two blocks of eight long; for the last digits 19 would do as well
MANY = 40  # sums of products; with more the code is written once, not once for each length of the sums
TOGETHER = 14  # sums of eight motions in one loop: each takes a register
FAST = "reassoc contract"  # sums of products may be taken in any order


@dataclass(frozen=True)
class Layout:
    """Where the coefficients are: rows of `stride` numbers, of `lanes` doubles each.

    Row i < states is component i from order 0 on. Row of (i, "forward"): order j at j; (i, "backward"): at `last` - j,
    order 0 not stored but zero, and zeros behind it; (i, "slope"): j times order j at j.
    """

    lanes: int
    stride: int
    last: int
    rows: dict[tuple[int, str], int]

    @property
    def doubles(self) -> int:
        return max(1, len(self.rows)) * self.stride * self.lanes


def _sums(series: int, r: Recurrence) -> list[tuple[tuple[int, str], tuple[int, str]]]:
    """The sums over j = 1 ... n - 1 of x_j y_(n - j) that a recurrence needs; both x and y by row."""

    def pair(x: int, slope: bool, y: int) -> tuple[tuple[int, str], tuple[int, str]]:
        return (x, "slope" if slope else "forward"), (y, "backward")

    of = r.of
    return {
        "*": lambda: [pair(of[0], False, of[1])],
        "square": lambda: [pair(of[0], False, of[0])],
        "/": lambda: [pair(series, False, of[1])],
        "sqrt": lambda: [pair(series, False, series)],
        "pow": lambda: [pair(of[0], True, series), pair(series, True, of[0])],
        "y'=wa'": lambda: [pair(of[1], True, of[0])],
        "y'=-wa'": lambda: [pair(of[1], True, of[0])],
        "y'=a'+y^2a'": lambda: [pair(of[1], True, of[0])],
        "y'=a'-y^2a'": lambda: [pair(of[1], True, of[0])],
        "wy'=a'": lambda: [pair(series, True, of[0])],
        "wy'=-a'": lambda: [pair(series, True, of[0])],
        "wy'=ab'-ba'": lambda: [pair(of[1], True, of[2]), pair(of[2], True, of[1]), pair(series, True, of[0])],
    }.get(r.kind, lambda: [])()


@lru_cache(maxsize=256)
def layout(found: Recurrences, lanes: int) -> Layout:
    """Rows for the states and for whatever a sum needs."""
    states = {r.of[0]: i for i, r in enumerate(found.series) if r.kind == "state"}
    rows = {(states[component], "forward"): component for component in sorted(states)}
    for i, r in enumerate(found.series):
        for x, (y, way) in _sums(i, r):
            rows.setdefault(x, len(rows))
            rows.setdefault((y, way if lanes == 1 else "forward"), len(rows))
    last = HIGHEST + 1
    beyond = LANES * max((blocks for *_, blocks in _stretches(found)), default=1)
    stride = ceil((last + beyond) / LANES) * LANES if lanes == 1 else last
    return Layout(lanes, stride, last, rows)


def _stretches(found: Recurrences) -> list[tuple[int, int, int]]:
    """(first, end, blocks): orders from `first` up to `end`, whose sums are so many blocks of eight long."""
    if sum(len(_sums(i, r)) for i, r in enumerate(found.series)) > MANY:
        return [(1, HIGHEST, 2)]
    return [(1, LANES + 2, 1), (LANES + 2, HIGHEST, 2)]


class _Series(Writer):
    """The function that fills the coefficients."""

    def __init__(self, found: Recurrences, place: Layout) -> None:
        super().__init__()
        self.found, self.place = found, place
        self.kind = "double" if place.lanes == 1 else f"<{place.lanes} x double>"
        self.suffix = "f64" if place.lanes == 1 else f"v{place.lanes}f64"
        self.first: dict[int, str] = {}  # the coefficients of order 0, of constants too
        self.inverse: dict[int, str] = {}  # 1 / w_0 of what is divided by
        self.now: dict[int, str] = {}  # of order n

    # Instructions on numbers of the kind

    def op(self, name: str, a: str, b: str) -> str:
        return self.emit(self.kind, f"f{name} {FAST} {self.kind} {a}, {b}").text

    def negative(self, a: str) -> str:
        return self.emit(self.kind, f"fneg {self.kind} {a}").text

    def constant(self, value: float) -> str:
        return self.spread(number(value))

    def spread(self, value: str) -> str:
        if self.place.lanes == 1:
            return value
        one = self.emit(self.kind, f"insertelement {self.kind} poison, double {value}, i32 0").text
        zeros = f"<{self.place.lanes} x i32> zeroinitializer"
        return self.emit(self.kind, f"shufflevector {self.kind} {one}, {self.kind} poison, {zeros}").text

    def address(self, row: int, index: str | int, scale: int) -> str:
        """Of a number at row and index; scale: doubles a step of the index."""
        base = row * self.place.stride * self.place.lanes
        if isinstance(index, int):
            return self.element("%work", base + index * scale)
        start = self.element("%work", base)
        step = index if scale == 1 else self.emit("i64", f"mul i64 {index}, {scale}").text
        return self.emit("ptr", f"getelementptr double, ptr {start}, i64 {step}").text

    def keep(self, row: int, index: str | int, value: str) -> None:
        self.do(f"store {self.kind} {value}, ptr {self.address(row, index, self.place.lanes)}, align 8")

    def kept(self, row: int, index: str | int) -> str:
        place = self.address(row, index, self.place.lanes)
        return self.emit(self.kind, f"load {self.kind}, ptr {place}, align 8").text

    def function(self, name: str, arguments: list[str]) -> str:
        """A function of each lane."""
        if name == "sqrt":
            return self.emit(self.kind, f"call {self.kind} @llvm.sqrt.{self.suffix}({self.kind} {arguments[0]})").text
        if self.place.lanes == 1:
            listed = ", ".join(f"double {a}" for a in arguments)
            return self.emit("double", f"call double @{name}({listed})").text
        whole = "poison"
        for lane in range(self.place.lanes):
            parts = [self.emit("double", f"extractelement {self.kind} {a}, i32 {lane}").text for a in arguments]
            one = self.emit("double", f"call double @{name}({', '.join(f'double {p}' for p in parts)})").text
            whole = self.emit(self.kind, f"insertelement {self.kind} {whole}, double {one}, i32 {lane}").text
        return whole

    # Order 0

    def values(self) -> None:
        """Coefficients of order 0: time and state are in memory."""
        for i in range(self.found.constants):
            place = self.element("%c", i)
            self.first[-1 - i] = self.spread(self.emit("double", f"load double, ptr {place}").text)
        for i, r in enumerate(self.found.series):
            self.first[i] = self.value(r)

    def value(self, r: Recurrence) -> str:
        if r.kind == "time":
            return self.emit(self.kind, f"load {self.kind}, ptr %t, align 8").text
        if r.kind == "state":
            return self.kept(r.of[0], 0)
        given = [self.first[i] for i in (r.arguments if r.value else r.of)]
        if r.value:
            return self.function(r.value, given)
        if r.kind == "neg":
            return self.negative(given[0])
        name = {"+": "add", "shift": "add", "-": "sub", "/": "div"}.get(r.kind, "mul")
        return self.op(name, given[0], given[-1])

    # Order n

    def coefficient(self, i: int, r: Recurrence, n: str, one_over_n: str, sums: list[str]) -> str:
        """The coefficient of order n; n and 1 / n are numbers of the kind."""
        of = [self.now.get(j, "") for j in r.of]  # empty where it comes later, and is not asked for
        start = [self.first.get(j, "") for j in r.of]
        if r.kind in ("+", "-"):
            return self.op("add" if r.kind == "+" else "sub", of[0], of[1])
        if r.kind == "neg":
            return self.negative(of[0])
        if r.kind == "shift":
            return of[0]
        if r.kind == "scale":
            return self.op("mul", of[0], start[1])
        if r.kind == "*":
            ends = self.op("add", self.op("mul", start[0], of[1]), self.op("mul", of[0], start[1]))
            return self.op("add", ends, sums[0])
        if r.kind == "square":
            end = self.op("mul", start[0], of[0])
            return self.op("add", self.op("add", end, end), sums[0])
        if r.kind == "/":
            end = self.op("mul", self.first[i], of[1])
            rest = self.op("add", end, sums[0])
            top = self.negative(rest) if r.of[0] < 0 else self.op("sub", of[0], rest)
            return self.op("mul", top, self.inverse[i])
        if r.kind == "sqrt":
            return self.op("mul", self.op("sub", of[0], sums[0]), self.inverse[i])
        return self.op("mul", self.derivative(i, r, n, of, start, sums), one_over_n)

    def derivative(self, i: int, r: Recurrence, n: str, of: list[str], start: list[str], sums: list[str]) -> str:
        """n times the coefficient, by the laws of derivatives."""
        if r.kind == "pow":
            end = self.op("mul", self.op("mul", n, of[0]), self.first[i])
            both = self.op("mul", start[1], self.op("add", end, sums[0]))
            return self.op("mul", self.op("sub", both, sums[1]), self.inverse[i])
        if r.kind == "wy'=ab'-ba'":
            ends = self.op("sub", self.op("mul", of[1], start[2]), self.op("mul", of[2], start[1]))
            rest = self.op("sub", self.op("sub", sums[0], sums[1]), sums[2])
            return self.op("mul", self.op("add", self.op("mul", n, ends), rest), self.inverse[i])
        slope = self.op("mul", n, of[1])
        if r.kind in ("wy'=a'", "wy'=-a'"):
            slope = slope if r.kind == "wy'=a'" else self.negative(slope)
            return self.op("mul", self.op("sub", slope, sums[0]), self.inverse[i])
        product = self.op("add", self.op("mul", slope, start[0]), sums[0])
        if r.kind in ("y'=wa'", "y'=-wa'"):
            return product if r.kind == "y'=wa'" else self.negative(product)
        return self.op("add" if r.kind == "y'=a'+y^2a'" else "sub", slope, product)

    def inverses(self) -> None:
        """What the recurrences divide by, once for all orders."""
        one = self.constant(1.0)
        for i, r in enumerate(self.found.series):
            w = {"/": r.of[-1:], "sqrt": (i,), "pow": r.of[:1]}.get(r.kind, r.of[:1] if r.kind[0] == "w" else ())
            for divisor in (self.first[j] for j in w):
                doubled = self.op("add", divisor, divisor) if r.kind == "sqrt" else divisor
                self.inverse[i] = self.op("div", one, doubled)

    def stored(self, i: int, n: str, n_number: str) -> None:
        """The coefficient of order n put where the sums look for it."""
        rows = self.place.rows
        if (i, "forward") in rows and self.found.series[i].kind != "state":
            self.keep(rows[i, "forward"], n, self.now[i])
        if (i, "backward") in rows:
            index = self.emit("i64", f"sub i64 {self.place.last}, {n}").text
            self.keep(rows[i, "backward"], index, self.now[i])
        if (i, "slope") in rows:
            self.keep(rows[i, "slope"], n, self.op("mul", n_number, self.now[i]))

    def sums(self, n: str, blocks: int) -> list[list[str]]:
        """The sums of each recurrence at order n."""
        listed = [_sums(i, r) for i, r in enumerate(self.found.series)]
        if self.place.lanes == 1:
            back = self.emit("i64", f"sub i64 {self.place.last + 1}, {n}").text
            return [[self.dot(x, y, back, blocks) for x, y in pairs] for pairs in listed]
        flat = [(x, (y, "forward")) for pairs in listed for x, (y, _) in pairs]
        found = [total for k in range(0, len(flat), TOGETHER) for total in self.totals(flat[k : k + TOGETHER], n)]
        return [[found.pop(0) for _ in pairs] for pairs in listed]

    def dot(self, x: tuple[int, str], y: tuple[int, str], back: str, blocks: int) -> str:
        """The sum of one motion: eight terms at a time, and these added up at the end."""
        vector, total = f"<{LANES} x double>", ""
        start = self.address(self.place.rows[y], back, 1)
        for block in range(blocks):
            left = self.element("%work", self.place.rows[x] * self.place.stride + 1 + LANES * block)
            right = self.element(start, LANES * block)
            a, b = (self.emit(vector, f"load {vector}, ptr {p}, align 8").text for p in (left, right))
            product = self.emit(vector, f"fmul {FAST} {vector} {a}, {b}").text
            total = self.emit(vector, f"fadd {FAST} {vector} {total}, {product}").text if total else product
        reduced = f"call {FAST} double @llvm.vector.reduce.fadd.v{LANES}f64(double -0.0, {vector} {total})"
        return self.emit("double", reduced).text

    def totals(self, pairs: list[tuple[tuple[int, str], tuple[int, str]]], n: str) -> list[str]:
        """Sums of eight motions each, in one loop over the terms."""
        before, test, inside, after = self.labels("before", "test", "inside", "after")
        self.jump(before)
        self.start(before)
        self.jump(test)
        self.start(test)
        j, more = f"%j{self.count}", f"%more{self.count}"
        names = [(f"%sum{self.count}_{k}", f"%next{self.count}_{k}") for k in range(len(pairs))]
        self.lines.append(f"  {j} = phi i64 [1, %{before}], [{more}, %{inside}]")
        for total, following in names:
            self.lines.append(f"  {total} = phi {self.kind} [zeroinitializer, %{before}], [{following}, %{inside}]")
        self.branch(self.emit("i1", f"icmp slt i64 {j}, {n}"), inside, after)
        self.start(inside)
        rest = self.emit("i64", f"sub i64 {n}, {j}").text
        xs = {x: self.kept(self.place.rows[x], j) for x, _ in pairs}
        ys = {y: self.kept(self.place.rows[y], rest) for _, y in pairs}
        for (x, y), (total, following) in zip(pairs, names, strict=True):
            product = self.op("mul", xs[x], ys[y])
            self.lines.append(f"  {following} = fadd {FAST} {self.kind} {total}, {product}")
        self.lines.append(f"  {more} = add i64 {j}, 1")
        self.jump(test)
        self.start(after)
        return [total for total, _ in names]

    def states(self, n: str, one_over_n: str, slots: list[str]) -> None:
        """The state's coefficients of order n, from the rates' of order n - 1."""
        for i, r in enumerate(self.found.series):
            if r.kind == "state":
                rate = self.emit(self.kind, f"load {self.kind}, ptr {slots[r.of[0]]}").text
                self.now[i] = self.op("mul", rate, one_over_n)
                self.keep(r.of[0], n, self.now[i])

    def stretch(self, first: int, end: int, blocks: int, slots: list[str]) -> None:
        """All series for the orders from first up to end, which is left out, and no further than asked for."""
        limit = self.emit("i64", f"call i64 @llvm.smin.i64(i64 %order, i64 {end})").text
        before, test, inside, after = self.labels("before", "test", "inside", "after")
        n, more = f"%n{self.count}", f"%more{self.count}"
        self.jump(before)
        self.start(before)
        self.jump(test)
        self.start(test)
        self.lines.append(f"  {n} = phi i64 [{first}, %{before}], [{more}, %last{more[1:]}]")
        self.branch(self.emit("i1", f"icmp slt i64 {n}, {limit}"), inside, after)
        self.start(inside)
        self.orders(n, blocks, slots)
        self.jump(f"last{more[1:]}")
        self.start(f"last{more[1:]}")
        self.lines.append(f"  {more} = add i64 {n}, 1")
        self.jump(test)
        self.start(after)

    def orders(self, n: str, blocks: int, slots: list[str]) -> None:
        zero = self.constant(0.0)
        self.now = dict.fromkeys(range(-self.found.constants, 0), zero)
        exact = self.emit("double", f"sitofp i64 {n} to double").text
        n_number = self.spread(exact)
        one_over_n = self.spread(self.emit("double", f"fdiv double 1.0, {exact}").text)
        sums = self.sums(n, blocks)
        self.states(n, one_over_n, slots)
        for i, r in enumerate(self.found.series):
            if r.kind == "time":
                first = self.emit("i1", f"icmp eq i64 {n}, 1").text
                self.now[i] = self.spread(self.emit("double", f"select i1 {first}, double 1.0, double 0.0").text)
            elif r.kind != "state":
                self.now[i] = self.coefficient(i, r, n_number, one_over_n, sums[i])
            self.stored(i, n, n_number)
        for slot, rate in zip(slots, self.found.rates, strict=True):
            self.do(f"store {self.kind} {self.now[rate]}, ptr {slot}")

    def written(self, name: str, everything: bool) -> list[str]:
        """The function: coefficients up to %order, or of the state up to order 1 only."""
        self.values()
        if everything:
            slots = [self.allocated(self.kind).text for _ in self.found.rates]
            for slot, rate in zip(slots, self.found.rates, strict=True):
                self.do(f"store {self.kind} {self.first[rate]}, ptr {slot}")
            self.inverses()
            for first, end, blocks in _stretches(self.found):
                self.stretch(first, end, blocks, slots)
            order = self.emit("double", "sitofp i64 %order to double").text
            one_over = self.spread(self.emit("double", f"fdiv double 1.0, {order}").text)
            self.states("%order", one_over, slots)
        else:
            for component, rate in enumerate(self.found.rates):
                self.keep(component, 1, self.first[rate])
        head = f"define internal void @{name}(ptr %work, ptr %c, ptr %t, i64 %order) {{"
        return [head, "entry:", *self.allocations, *self.lines, "  ret void", "}"]


def series_text(found: Recurrences, place: Layout) -> list[str]:
    """The functions `coefficients` and `rates` of (work, constants, time): work holds the state at order 0."""
    both = (_Series(found, place).written("coefficients", True), _Series(found, place).written("rates", False))
    return [line for text in both for line in text]
