"""Translates a subset of Python to LLVM's representation: the loops over the steps, and the generated formulas.

Each call is inlined, so the result is one function. Types are inferred from the arguments of the entry; a tuple is a
compile-time tuple of values, an array is an address. The order of arithmetic is Python's, so both give the same bits.
"""

import ast
import math
import operator
from collections.abc import Callable, Mapping, Sequence

from tam570.integrate.compiled.ir import Array, Operand, Slot, Value, Writer, number
from tam570.integrate.trace import FUNCTIONS
from tam570.values import Function, Json, Parameters

Names = Json

LIBM = {*FUNCTIONS.values(), "pow"}  # C has them by these names
ROOTS = {"sqrt": "llvm.sqrt", "fabs": "llvm.fabs", "abs": "llvm.fabs", "floor": "llvm.floor"}
ARITHMETIC: dict[type[ast.operator], tuple[str, Callable[[Operand, Operand], Operand]]] = {
    ast.Add: ("add", operator.add),
    ast.Sub: ("sub", operator.sub),
    ast.Mult: ("mul", operator.mul),
    ast.Div: ("div", operator.truediv),
}
ORDER: dict[type[ast.cmpop], tuple[str, str]] = {  # instructions for floats and integers
    ast.Lt: ("olt", "slt"),
    ast.LtE: ("ole", "sle"),
    ast.Gt: ("ogt", "sgt"),
    ast.GtE: ("oge", "sge"),
    ast.Eq: ("oeq", "eq"),
    ast.NotEq: ("une", "ne"),
}
KNOWN = {"inf": math.inf, "nan": math.nan, "True": True, "False": False, "None": None}


class Translator(Writer):
    """Translates the body of a function: `do_X` writes the statement X of `ast`, `of_X` returns the value of X."""

    def __init__(self, functions: Mapping[str, ast.FunctionDef], names: Parameters) -> None:
        super().__init__()
        self.globals = {**KNOWN, **{name: self._inlined(node) for name, node in functions.items()}, **names}
        self.width = 1  # doubles in a vector
        self.together = 1  # components in a vector
        self.flags = ""  # fast-math flags of additions and products; none, to get Python's bits
        self.components = 0  # padded to whole vectors
        self.tables: dict[tuple[float, ...], str] = {}
        self.loops: list[str] = []  # labels for `break`
        self.returns: list[tuple[str, Operand]] = []  # labels for `return`, and slots of the values

    def _inlined(self, node: ast.FunctionDef) -> Function:
        straight = not any(isinstance(part, ast.If | ast.For | ast.While) for part in node.body)

        def call(_: Operand, *arguments: Operand) -> Operand:
            names: Names = dict(zip((a.arg for a in node.args.args), arguments, strict=True))
            if straight:
                return self._straight(names, node.body)
            names = {name: self.stored(None, value) for name, value in names.items()}
            (done,) = self.labels("done")
            self.returns.append((done, None))
            if self.body(names, node.body):
                self.jump(done)
            self.start(done)
            return self.loaded(self.returns.pop()[1])

        return call

    def _straight(self, names: Names, body: Sequence[ast.stmt]) -> Operand:
        """Write a function without branches, whose variables stay in registers; return its result."""
        for statement in body:
            if isinstance(statement, ast.Return):
                return self.value(names, statement.value) if statement.value else ()
            if isinstance(statement, ast.Assign):
                value = self.value(names, statement.value)
                for target in statement.targets:
                    self.bind(names, target, value)
            else:
                self.statement(names, statement)
        return ()

    def bind(self, names: Names, target: ast.expr, value: Operand) -> None:
        if isinstance(target, ast.Tuple):
            for part, item in zip(target.elts, value, strict=True):
                self.bind(names, part, item)
        elif isinstance(target, ast.Name):
            names[target.id] = value
        else:
            self.assign(names, target, value)

    def assign(self, names: Names, target: ast.expr, value: Operand) -> None:
        if isinstance(target, ast.Tuple):
            for part, item in zip(target.elts, value, strict=True):
                self.assign(names, part, item)
        elif isinstance(target, ast.Subscript):
            pointer, ir_type = self.address(names, target)
            self.do(f"store {ir_type} {self.text(value, ir_type)}, ptr {pointer}, align 8")
        elif isinstance(target, ast.Name):
            names[target.id] = self.stored(names.get(target.id), value)

    def stored(self, slot: Operand, value: Operand) -> Operand:
        """Store a value in a variable's slot, or in a new one; return the slot."""
        if isinstance(value, tuple):
            places = slot if isinstance(slot, tuple) and len(slot) == len(value) else [None] * len(value)
            return tuple(self.stored(p, v) for p, v in zip(places, value, strict=True))
        if not isinstance(value, Value | float | int) or getattr(value, "ir_type", "") == "lanes":
            return value
        if not isinstance(slot, Slot):
            slot = self.allocated(value.ir_type if isinstance(value, Value) else _kind(value))
        self.store(value, slot)
        return slot

    def body(self, names: Names, statements: Sequence[ast.stmt]) -> bool:
        """Write statements; return whether control reaches their end."""
        return all(self.statement(names, statement) for statement in statements)

    def statement(self, names: Names, node: ast.stmt) -> bool:
        return bool(getattr(self, f"do_{type(node).__name__}")(names, node))

    def do_Expr(self, names: Names, node: ast.Expr) -> bool:
        if not isinstance(node.value, ast.Constant):  # else a docstring
            self.value(names, node.value)
        return True

    def do_Assign(self, names: Names, node: ast.Assign) -> bool:
        value = self.value(names, node.value)
        for target in node.targets:
            self.assign(names, target, value)
        return True

    def do_AugAssign(self, names: Names, node: ast.AugAssign) -> bool:
        old, change = self.value(names, node.target), self.value(names, node.value)
        self.assign(names, node.target, self.arithmetic(node.op, old, change))
        return True

    def do_If(self, names: Names, node: ast.If) -> bool:
        test = self.value(names, node.test)
        if not isinstance(test, Value):  # a compile-time constant
            return self.body(names, node.body if test else node.orelse)
        yes, no, after = self.labels("yes", "no", "after")
        self.branch(test, yes, no)
        reached = []
        for label, part in ((yes, node.body), (no, node.orelse)):
            self.start(label)
            reached.append(self.body(names, part))
            if reached[-1]:
                self.jump(after)
        if any(reached):
            self.start(after)
        return any(reached)

    def do_While(self, names: Names, node: ast.While) -> bool:
        test, body_label, after = self.labels("test", "inside", "after")
        self.jump(test)
        self.start(test)
        self.branch(self.value(names, node.test), body_label, after)
        self.start(body_label)
        self._looped(names, node.body, test, after)
        self.start(after)
        return True

    def _looped(self, names: Names, body: Sequence[ast.stmt], next_label: str, after: str) -> None:
        self.loops.append(after)
        if self.body(names, body):
            self.jump(next_label)
        self.loops.pop()

    def do_For(self, names: Names, node: ast.For) -> bool:
        if isinstance(node.iter, ast.Call) and ast.unparse(node.iter.func) == "components":
            return self._by_vectors(names, node)
        bounds = self._bounds(names, node.iter)
        if bounds and any(isinstance(bound, Value) for bound in bounds):
            return self._counted(names, node.body, bounds, lambda i: self.assign(names, node.target, i))
        items = tuple(range(*bounds)) if bounds else self.value(names, node.iter)
        if items and isinstance(items[0], float | tuple):
            return self._over_table(names, node, items)
        for item in items:  # unrolled
            self.bind(names, node.target, item)
            self.body(names, node.body)
        return True

    def _by_vectors(self, names: Names, node: ast.For) -> bool:
        """Write a loop over the components, vector by vector."""
        if self.width == 1:
            bounds = 0, self.globals["SIZE"]
            return self._counted(names, node.body, bounds, lambda i: self.assign(names, node.target, i))
        if self.components == self.together:
            self.bind(names, node.target, Value("lanes", "0"))
            return self.body(names, node.body)
        bounds = 0, Value("i64", str(self.components))
        return self._counted(
            names, node.body, bounds, lambda i: self.bind(names, node.target, Value("lanes", i.text)), self.together
        )

    def _bounds(self, names: Names, node: ast.expr) -> tuple[Operand, ...]:
        if not (isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "range"):
            return ()
        arguments = [self.value(names, argument) for argument in node.args]
        return (0, *arguments) if len(arguments) == 1 else tuple(arguments)

    def _counted(
        self,
        names: Names,
        body: Sequence[ast.stmt],
        bounds: tuple[Operand, ...],
        bind: Callable[[Value], None],
        step: int = 1,
    ) -> bool:
        first, last = bounds
        counter, end = self.allocated("i64"), self.text(last, "i64")
        test, body_label, more, after = self.labels("test", "inside", "more", "after")
        self.store(first, counter)
        self.jump(test)
        self.start(test)
        i = self.load(counter)
        self.branch(self.emit("i1", f"icmp slt i64 {i.text}, {end}"), body_label, after)
        self.start(body_label)
        bind(i)
        self._looped(names, body, more, after)
        self.start(more)
        self.store(self.emit("i64", f"add i64 {self.load(counter).text}, {step}"), counter)
        self.jump(test)
        self.start(after)
        return True

    def _over_table(self, names: Names, node: ast.For, rows: tuple[Operand, ...]) -> bool:
        """Write a loop over constant numbers, or rows of them, which become tables in memory."""
        columns = list(zip(*rows, strict=True)) if isinstance(rows[0], tuple) else [rows]
        targets = node.target.elts if isinstance(node.target, ast.Tuple) else [node.target]

        def bind(i: Value) -> None:
            for target, column in zip(targets, columns, strict=True):
                table = self.tables.setdefault(column, f"@table{len(self.tables)}")
                self.assign(names, target, self.emit("double", f"load double, ptr {self.element(table, i)}"))

        return self._counted(names, node.body, (0, len(rows)), bind)

    def do_Break(self, names: Names, node: ast.Break) -> bool:
        self.jump(self.loops[-1])
        return False

    def do_Return(self, names: Names, node: ast.Return) -> bool:
        label, slot = self.returns[-1]
        value = self.value(names, node.value) if node.value else ()
        self.returns[-1] = label, self.stored(slot, value)
        self.jump(label)
        return False

    def constants(self) -> list[str]:
        """Return the definitions of the tables."""
        return [
            f"{name} = internal constant [{len(table)} x double] [{', '.join(f'double {number(x)}' for x in table)}]"
            for table, name in self.tables.items()
        ]

    def value(self, names: Names, node: ast.expr) -> Operand:
        return getattr(self, f"of_{type(node).__name__}")(names, node)

    def of_Constant(self, names: Names, node: ast.Constant) -> Operand:
        return node.value

    def of_Name(self, names: Names, node: ast.Name) -> Operand:
        if node.id in names:
            return self.loaded(names[node.id])
        return self.globals.get(node.id, node.id)  # else a function's name

    def loaded(self, slot: Operand) -> Operand:
        if isinstance(slot, tuple):
            return tuple(self.loaded(part) for part in slot)
        return self.load(slot) if isinstance(slot, Slot) else slot

    def of_Tuple(self, names: Names, node: ast.Tuple) -> Operand:
        return tuple(self.value(names, part) for part in node.elts)

    def of_Subscript(self, names: Names, node: ast.Subscript) -> Operand:
        items = self.value(names, node.value)
        if isinstance(items, tuple):
            return items[self.value(names, node.slice)]
        pointer, ir_type = self.address(names, node)
        return self.emit(ir_type, f"load {ir_type}, ptr {pointer}, align 8")

    def address(self, names: Names, node: ast.Subscript) -> tuple[str, str]:
        """Return the address of an array's element and its type: a double or a vector."""
        array, index = self.value(names, node.value), self.value(names, node.slice)
        if isinstance(index, tuple):
            rows = self.arithmetic(ast.Mult(), index[0], array.row)
            index = self.arithmetic(ast.Add(), rows, index[1])
        is_vector = isinstance(index, Value) and index.ir_type == "lanes"
        return self.element(array.text, index), f"<{self.width} x double>" if is_vector else "double"

    def of_BinOp(self, names: Names, node: ast.BinOp) -> Operand:
        a, b = self.value(names, node.left), self.value(names, node.right)
        if isinstance(node.op, ast.Pow):
            fold = not isinstance(a, Value) and not isinstance(b, Value)
            return a**b if fold else self.call("pow", [a, b])
        return self.arithmetic(node.op, a, b)

    def arithmetic(self, sign: ast.operator, a: Operand, b: Operand) -> Operand:
        name, fold = ARITHMETIC[type(sign)]
        if not isinstance(a, Value) and not isinstance(b, Value):
            return fold(a, b)
        is_integer = _whole(a) and _whole(b) and name != "div"
        ir_type, instruction = ("i64", name) if is_integer else (_number(a, b), f"f{name}{self.flags}")
        result = self.emit(ir_type, f"{instruction} {ir_type} {self.text(a, ir_type)}, {self.text(b, ir_type)}")
        is_lanes = is_integer and any(isinstance(part, Value) and part.ir_type == "lanes" for part in (a, b))
        return Value("lanes", result.text) if is_lanes else result

    def of_UnaryOp(self, names: Names, node: ast.UnaryOp) -> Operand:
        value = self.value(names, node.operand)
        if isinstance(node.op, ast.Not):
            return self.emit("i1", f"xor i1 {self.text(value, 'i1')}, true") if isinstance(value, Value) else not value
        if not isinstance(value, Value):
            return -value
        ir_type = value.ir_type
        return self.emit(ir_type, f"sub i64 0, {value.text}" if ir_type == "i64" else f"fneg {ir_type} {value.text}")

    def of_Compare(self, names: Names, node: ast.Compare) -> Operand:
        """Compare, as in a < b < c; evaluate all parts, since they have no side effects."""
        values = [self.value(names, part) for part in (node.left, *node.comparators)]
        tests = [self.compared(sign, a, b) for sign, a, b in zip(node.ops, values, values[1:], strict=False)]
        result = tests[0]
        for test in tests[1:]:
            result = self.emit("i1", f"and i1 {self.text(result, 'i1')}, {self.text(test, 'i1')}")
        return result

    def compared(self, sign: ast.cmpop, a: Operand, b: Operand) -> Value:
        floats, integers = ORDER[type(sign)]
        if _whole(a) and _whole(b):
            return self.emit("i1", f"icmp {integers} i64 {self.text(a, 'i64')}, {self.text(b, 'i64')}")
        ir_type = _number(a, b)
        return self.emit(
            ir_type.replace("double", "i1"), f"fcmp {floats} {ir_type} {self.text(a, ir_type)}, {self.text(b, ir_type)}"
        )

    def of_BoolOp(self, names: Names, node: ast.BoolOp) -> Operand:
        """Evaluate later operands only if needed: an index in them may be out of range."""
        slot, (after,) = self.allocated("i1"), self.labels("after")
        for part in node.values:
            test = self.value(names, part)
            test = test if isinstance(test, Value) else bool(test)
            self.store(test, slot)
            (more,) = self.labels("more")
            yes, no = (more, after) if isinstance(node.op, ast.And) else (after, more)
            self.branch(test, yes, no)
            self.start(more)
        self.jump(after)
        self.start(after)
        return self.load(slot)

    def of_IfExp(self, names: Names, node: ast.IfExp) -> Operand:
        test = self.value(names, node.test)
        if not isinstance(test, Value):
            return self.value(names, node.body if test else node.orelse)
        return self.chosen(test, self.value(names, node.body), self.value(names, node.orelse))

    def chosen(self, test: Value, yes: Operand, no: Operand) -> Value:
        ir_type = "i64" if _whole(yes) and _whole(no) else _number(yes, no)
        yes, no = self.text(yes, ir_type), self.text(no, ir_type)
        return self.emit(ir_type, f"select {test.ir_type} {test.text}, {ir_type} {yes}, {ir_type} {no}")

    def of_Call(self, names: Names, node: ast.Call) -> Operand:
        arguments = [self.value(names, argument) for argument in node.args]
        return self.call(self.value(names, node.func), arguments)

    def call(self, function: Operand, arguments: list[Operand]) -> Operand:
        if callable(function):
            return function(self, *arguments)
        if function in ("min", "max"):
            return self.extreme(function, arguments)
        if function in ROOTS:
            ir_type = _number(*arguments)
            name = ROOTS[function] + (f".v{self.width}f64" if ir_type[0] == "<" else ".f64")
            return self.emit(ir_type, f"call {ir_type} @{name}({ir_type} {self.text(arguments[0], ir_type)})")
        if function in LIBM:
            listed = ", ".join(f"double {self.text(x, 'double')}" for x in arguments)
            return self.emit("double", f"call double @{function}({listed})")
        if function == "len" and isinstance(arguments[0], tuple | Array):
            return len(arguments[0]) if isinstance(arguments[0], tuple) else arguments[0].length
        if function == "float":
            return Value("double", self.text(arguments[0], "double"))
        if function == "int":
            return self.emit("i64", f"fptosi double {self.text(arguments[0], 'double')} to i64")
        raise NotImplementedError(function)

    def extreme(self, function: str, arguments: list[Operand]) -> Operand:
        """Return min or max as Python does: replace the first only by a value beyond it, so min(1, nan) is 1."""
        result = arguments[0]
        for other in arguments[1:]:
            beyond = self.compared(ast.Lt() if function == "min" else ast.Gt(), other, result)
            result = self.chosen(beyond, other, result)
        return result


def _kind(value: float) -> str:
    return "i1" if isinstance(value, bool) else "i64" if isinstance(value, int) else "double"


def _whole(value: Operand) -> bool:
    return value.ir_type in ("i64", "lanes") if isinstance(value, Value) else isinstance(value, int)


def _number(*values: Operand) -> str:
    """Return the common type: a vector if any value is one, else double."""
    types = [value.ir_type for value in values if isinstance(value, Value)]
    return next((ir_type for ir_type in types if ir_type[0] == "<"), "double")


def functions_of(source: str) -> dict[str, ast.FunctionDef]:
    """Return all functions that a source defines by name, including nested ones."""
    functions: dict[str, ast.FunctionDef] = {}
    bodies: list[Sequence[ast.stmt]] = [ast.parse(source).body]
    for body in bodies:
        for node in body:
            if isinstance(node, ast.FunctionDef):
                functions[node.name] = node
            bodies.append(getattr(node, "body", ()))
    return functions
