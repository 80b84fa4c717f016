"""Plain Python as LLVM's representation: the loops over the steps, and the formulas generated for them.

A function is translated where it is called, so that all is one in the end. The kinds of the variables follow from
what the entry is given; a tuple is known by its members; an array is an address.
"""

import ast
from collections.abc import Callable, Mapping, Sequence

from tam570.integrate.compiled.expressions import Expressions, Names
from tam570.integrate.compiled.ir import Operand, Slot, Untranslatable, Value, number
from tam570.values import Function, Parameters

__all__ = ["Translator", "functions_of"]

BRANCHING = ast.If | ast.For | ast.While


def functions_of(source: str) -> dict[str, ast.FunctionDef]:
    """Return the functions that a source defines, those inside of others too, by name."""
    return {node.name: node for node in ast.walk(ast.parse(source)) if isinstance(node, ast.FunctionDef)}


class Translator(Expressions):
    """The body of one function of the representation."""

    def __init__(self, functions: Mapping[str, ast.FunctionDef], names: Parameters) -> None:
        super().__init__({**{name: self._inlined(node) for name, node in functions.items()}, **names})
        self.components = 0  # with what fills up the last vector
        self.tables: dict[tuple[float, ...], str] = {}
        self.loops: list[tuple[str, str]] = []  # where `continue` and `break` go
        self.returns: list[tuple[str, Operand]] = []  # where `return` goes, and its value's place

    def _inlined(self, node: ast.FunctionDef) -> Function:
        straight = not any(isinstance(part, BRANCHING) for part in node.body)

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
        """Return a function without branches: its variables need no memory."""
        for statement in body:
            if isinstance(statement, ast.Return):
                return self.value(names, statement.value) if statement.value else ()
            if isinstance(statement, ast.Assign):
                value = self.value(names, statement.value)
                for target in statement.targets:
                    self.bind(names, target, value)
            elif isinstance(statement, ast.AugAssign) and isinstance(statement.target, ast.Name):
                value = self.value(names, statement.value)
                names[statement.target.id] = self.arithmetic(statement.op, names[statement.target.id], value)
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
        """Return the place of a variable that now has this value."""
        if isinstance(value, tuple):
            places = slot if isinstance(slot, tuple) and len(slot) == len(value) else [None] * len(value)
            return tuple(self.stored(p, v) for p, v in zip(places, value, strict=True))
        if not isinstance(value, Value | float | int):
            return value
        if isinstance(value, Value) and value.ir_type == "lanes":
            return value
        if not isinstance(slot, Slot):
            slot = self.allocated(value.ir_type if isinstance(value, Value) else _kind(value))
        self.store(value, slot)
        return slot

    def body(self, names: Names, statements: Sequence[ast.stmt]) -> bool:
        """Return whether the end of the statements is reached."""
        return all(self.statement(names, statement) for statement in statements)

    def statement(self, names: Names, node: ast.stmt) -> bool:
        method = getattr(self, f"do_{type(node).__name__}", None)
        if method is None:
            raise Untranslatable(f"{type(node).__name__} in {ast.unparse(node)}")
        return bool(method(names, node))

    def do_Expr(self, names: Names, node: ast.Expr) -> bool:
        if not isinstance(node.value, ast.Constant):  # a docstring
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
        if not isinstance(test, Value):  # known already
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
        self.loops.append((next_label, after))
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
        for item in items:  # written out as often as the tuple is long
            self.bind(names, node.target, item)
            self.body(names, node.body)
        return True

    def _by_vectors(self, names: Names, node: ast.For) -> bool:
        """Return a loop over the components, as many at a time as there are in a vector."""
        if self.width == 1:
            bounds = 0, self.globals["SIZE"]
            return self._counted(names, node.body, bounds, lambda i: self.assign(names, node.target, i))
        if self.components == self.width:
            self.bind(names, node.target, Value("lanes", "0"))
            return self.body(names, node.body)
        bounds = 0, Value("i64", str(self.components))
        return self._counted(
            names, node.body, bounds, lambda i: self.bind(names, node.target, Value("lanes", i.text)), self.width
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
        """Return a loop over numbers that are known: they are kept in memory, column by column."""
        columns = list(zip(*rows, strict=True)) if isinstance(rows[0], tuple) else [rows]
        targets = node.target.elts if isinstance(node.target, ast.Tuple) else [node.target]

        def bind(i: Value) -> None:
            for target, column in zip(targets, columns, strict=True):
                table = self.tables.setdefault(column, f"@table{len(self.tables)}")
                self.assign(names, target, self.emit("double", f"load double, ptr {self.element(table, i)}"))

        return self._counted(names, node.body, (0, len(rows)), bind)

    def do_Break(self, names: Names, node: ast.Break) -> bool:
        self.jump(self.loops[-1][1])
        return False

    def do_Continue(self, names: Names, node: ast.Continue) -> bool:
        self.jump(self.loops[-1][0])
        return False

    def do_Return(self, names: Names, node: ast.Return) -> bool:
        label, slot = self.returns[-1]
        value = self.value(names, node.value) if node.value else ()
        self.returns[-1] = label, self.stored(slot, value)
        self.jump(label)
        return False

    def constants(self) -> list[str]:
        """Return the tables' definitions."""
        return [
            f"{name} = internal constant [{len(table)} x double] [{', '.join(f'double {number(x)}' for x in table)}]"
            for table, name in self.tables.items()
        ]


def _kind(value: float) -> str:
    return "i1" if isinstance(value, bool) else "i64" if isinstance(value, int) else "double"
