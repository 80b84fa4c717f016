"""Python's expressions as instructions: arithmetic in Python's order, so that both give the same bits."""

import ast
import math
import operator
from collections.abc import Callable

from tam570.integrate.compiled.ir import Array, Operand, Slot, Untranslatable, Value, Writer
from tam570.values import Json, Parameters

__all__ = ["Expressions", "Names"]

Names = Json

_LIBM = "sin cos tan asin acos atan sinh cosh tanh asinh acosh atanh exp exp2 expm1 log log1p log2 log10 cbrt erf erfc"
LIBM = frozenset(_LIBM.split(" "))
LIBM_OF_TWO = frozenset(("atan2", "hypot", "pow"))
ROOTS = {"sqrt": "llvm.sqrt", "fabs": "llvm.fabs", "abs": "llvm.fabs"}
ARITHMETIC: dict[type[ast.operator], tuple[str, Callable[[Operand, Operand], Operand]]] = {
    ast.Add: ("add", operator.add),
    ast.Sub: ("sub", operator.sub),
    ast.Mult: ("mul", operator.mul),
    ast.Div: ("div", operator.truediv),
    ast.FloorDiv: ("sdiv", operator.floordiv),
}
ORDER: dict[type[ast.cmpop], tuple[str, str, Callable[[Operand, Operand], bool]]] = {
    ast.Lt: ("olt", "slt", operator.lt),
    ast.LtE: ("ole", "sle", operator.le),
    ast.Gt: ("ogt", "sgt", operator.gt),
    ast.GtE: ("oge", "sge", operator.ge),
    ast.Eq: ("oeq", "eq", operator.eq),
    ast.NotEq: ("une", "ne", operator.ne),
}
KNOWN = {"inf": math.inf, "nan": math.nan, "True": True, "False": False, "None": None}


class Expressions(Writer):
    """Values of expressions, given the names that they are in terms of."""

    def __init__(self, names: Parameters) -> None:
        super().__init__()
        self.globals = {**KNOWN, **names}
        self.width = 1  # of vectors
        self.flags = ""  # of additions and products: none, so that both give Python's bits

    def value(self, names: Names, node: ast.expr) -> Operand:
        method = getattr(self, f"of_{type(node).__name__}", None)
        if method is None:
            raise Untranslatable(f"{type(node).__name__} in {ast.unparse(node)}")
        return method(names, node)

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
        """Return where it is and what is there: a number, or a vector."""
        array, index = self.value(names, node.value), self.value(names, node.slice)
        if not isinstance(array, Array):
            raise Untranslatable(f"{ast.unparse(node)}: not an array")
        if isinstance(index, tuple):
            rows = self.arithmetic(ast.Mult(), index[0], array.row)
            index = self.arithmetic(ast.Add(), rows, index[1])
        is_vector = isinstance(index, Value) and index.ir_type == "lanes"
        return self.element(array.text, index), f"<{self.width} x double>" if is_vector else "double"

    def of_BinOp(self, names: Names, node: ast.BinOp) -> Operand:
        left, right = self.value(names, node.left), self.value(names, node.right)
        if isinstance(node.op, ast.Pow):
            fold = not isinstance(left, Value) and not isinstance(right, Value)
            return left**right if fold else self.call("pow", [left, right])
        return self.arithmetic(node.op, left, right)

    def arithmetic(self, sign: ast.operator, left: Operand, right: Operand) -> Operand:
        name, fold = ARITHMETIC[type(sign)]
        if not isinstance(left, Value) and not isinstance(right, Value):
            return fold(left, right)
        items = _whole(left) and _whole(right) and name != "div"
        ir_type, instruction = ("i64", name) if items else (_number(left, right), f"f{name}{self.flags}")
        result = self.emit(ir_type, f"{instruction} {ir_type} {self.text(left, ir_type)}, {self.text(right, ir_type)}")
        is_lanes = items and any(isinstance(part, Value) and part.ir_type == "lanes" for part in (left, right))
        return Value("lanes", result.text) if is_lanes else result

    def of_UnaryOp(self, names: Names, node: ast.UnaryOp) -> Operand:
        value = self.value(names, node.operand)
        if isinstance(node.op, ast.Not):
            return self.emit("i1", f"xor i1 {self.text(value, 'i1')}, true") if isinstance(value, Value) else not value
        if isinstance(node.op, ast.UAdd):
            return value
        if not isinstance(value, Value):
            return -value
        ir_type = value.ir_type
        return self.emit(ir_type, f"sub i64 0, {value.text}" if ir_type == "i64" else f"fneg {ir_type} {value.text}")

    def of_Compare(self, names: Names, node: ast.Compare) -> Operand:
        """Compare a < b < c: all parts are evaluated, as they have no side effects."""
        values = [self.value(names, part) for part in (node.left, *node.comparators)]
        tests = [self.compared(sign, a, b) for sign, a, b in zip(node.ops, values, values[1:], strict=False)]
        result = tests[0]
        for test in tests[1:]:
            result = self.emit("i1", f"and i1 {self.text(result, 'i1')}, {self.text(test, 'i1')}")
        return result

    def compared(self, sign: ast.cmpop, left: Operand, right: Operand) -> Operand:
        floats, integers, fold = ORDER[type(sign)]
        if not isinstance(left, Value) and not isinstance(right, Value):
            return fold(left, right)
        if _whole(left) and _whole(right):
            return self.emit("i1", f"icmp {integers} i64 {self.text(left, 'i64')}, {self.text(right, 'i64')}")
        ir_type = _number(left, right)
        return self.emit(
            ir_type.replace("double", "i1"),
            f"fcmp {floats} {ir_type} {self.text(left, ir_type)}, {self.text(right, ir_type)}",
        )

    def of_BoolOp(self, names: Names, node: ast.BoolOp) -> Operand:
        """Return what comes second is looked at only where the first leaves it open: an index may be beyond the end."""
        slot, (after,) = self.allocated("i1"), self.labels("after")
        for part in node.values:
            test = self.value(names, part)
            self.store(test if isinstance(test, Value) else bool(test), slot)
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
        if function in LIBM or function in LIBM_OF_TWO:
            listed = ", ".join(f"double {self.text(x, 'double')}" for x in arguments)
            return self.emit("double", f"call double @{function}({listed})")
        if function == "len" and isinstance(arguments[0], tuple | Array):
            return len(arguments[0]) if isinstance(arguments[0], tuple) else arguments[0].length
        if function == "float":
            return Value("double", self.text(arguments[0], "double"))
        if function == "int":
            return self.emit("i64", f"fptosi double {self.text(arguments[0], 'double')} to i64")
        raise Untranslatable(f"call of {function}")

    def extreme(self, function: str, arguments: list[Operand]) -> Operand:
        """As Python does it: the first unless a later one is beyond; so min(1, nan) is 1."""
        result = arguments[0]
        for other in arguments[1:]:
            beyond = self.compared(ast.Lt() if function == "min" else ast.Gt(), other, result)
            fold = other if beyond else result
            result = self.chosen(beyond, other, result) if isinstance(beyond, Value) else fold
        return result


def _whole(value: Operand) -> bool:
    return value.ir_type in ("i64", "lanes") if isinstance(value, Value) else isinstance(value, int)


def _number(*values: Operand) -> str:
    """Return the type of what is made of them: a vector if one is."""
    types = [value.ir_type for value in values if isinstance(value, Value)]
    return next((ir_type for ir_type in types if ir_type[0] == "<"), "double")
