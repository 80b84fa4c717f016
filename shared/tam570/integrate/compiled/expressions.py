"""Python's expressions as instructions: arithmetic in Python's order, so that both give the same bits."""

import ast
import math
import operator
from collections.abc import Callable, Mapping
from typing import Any

from tam570.integrate.compiled.ir import Array, Slot, Untranslatable, Value, Writer

__all__ = ["Expressions", "Names"]

Names = dict[str, Any]

_LIBM = "sin cos tan asin acos atan sinh cosh tanh asinh acosh atanh exp exp2 expm1 log log1p log2 log10 cbrt erf erfc"
LIBM = frozenset(_LIBM.split(" "))
LIBM_OF_TWO = frozenset(("atan2", "hypot", "pow"))
ROOTS = {"sqrt": "llvm.sqrt.f64", "fabs": "llvm.fabs.f64", "abs": "llvm.fabs.f64"}
ARITHMETIC: dict[type[ast.operator], tuple[str, Callable[[Any, Any], Any]]] = {
    ast.Add: ("add", operator.add),
    ast.Sub: ("sub", operator.sub),
    ast.Mult: ("mul", operator.mul),
    ast.Div: ("div", operator.truediv),
    ast.FloorDiv: ("sdiv", operator.floordiv),
}
ORDER: dict[type[ast.cmpop], tuple[str, str, Callable[[Any, Any], bool]]] = {
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

    def __init__(self, names: Mapping[str, Any]) -> None:
        super().__init__()
        self.globals = {**KNOWN, **names}
        self.flags = ""  # of additions and products: none, so that both give Python's bits

    def value(self, names: Names, node: ast.expr) -> Any:
        method = getattr(self, f"of_{type(node).__name__}", None)
        if method is None:
            raise Untranslatable(f"{type(node).__name__} in {ast.unparse(node)}")
        return method(names, node)

    def of_Constant(self, names: Names, node: ast.Constant) -> Any:
        return node.value

    def of_Name(self, names: Names, node: ast.Name) -> Any:
        if node.id in names:
            return self.loaded(names[node.id])
        return self.globals.get(node.id, node.id)  # else a function's name

    def loaded(self, place: Any) -> Any:
        if isinstance(place, tuple):
            return tuple(self.loaded(part) for part in place)
        return self.load(place) if isinstance(place, Slot) else place

    def of_Tuple(self, names: Names, node: ast.Tuple) -> Any:
        return tuple(self.value(names, part) for part in node.elts)

    def of_Subscript(self, names: Names, node: ast.Subscript) -> Any:
        whole = self.value(names, node.value)
        if isinstance(whole, tuple):
            return whole[self.value(names, node.slice)]
        return self.emit("double", f"load double, ptr {self.address(names, node)}")

    def address(self, names: Names, node: ast.Subscript) -> str:
        array, index = self.value(names, node.value), self.value(names, node.slice)
        if not isinstance(array, Array):
            raise Untranslatable(f"{ast.unparse(node)}: not an array")
        if isinstance(index, tuple):
            rows = self.arithmetic(ast.Mult(), index[0], array.row)
            index = self.arithmetic(ast.Add(), rows, index[1])
        return self.element(array.text, index)

    def of_BinOp(self, names: Names, node: ast.BinOp) -> Any:
        left, right = self.value(names, node.left), self.value(names, node.right)
        if isinstance(node.op, ast.Pow):
            known = not isinstance(left, Value) and not isinstance(right, Value)
            return left**right if known else self.called("pow", [left, right])
        return self.arithmetic(node.op, left, right)

    def arithmetic(self, sign: ast.operator, left: Any, right: Any) -> Any:
        name, known = ARITHMETIC[type(sign)]
        if not isinstance(left, Value) and not isinstance(right, Value):
            return known(left, right)
        whole = _whole(left) and _whole(right) and name != "div"
        kind, instruction = ("i64", name) if whole else ("double", f"f{name}{self.flags}")
        return self.emit(kind, f"{instruction} {kind} {self.text(left, kind)}, {self.text(right, kind)}")

    def of_UnaryOp(self, names: Names, node: ast.UnaryOp) -> Any:
        value = self.value(names, node.operand)
        if isinstance(node.op, ast.Not):
            return self.emit("i1", f"xor i1 {self.text(value, 'i1')}, true") if isinstance(value, Value) else not value
        if isinstance(node.op, ast.UAdd):
            return value
        if not isinstance(value, Value):
            return -value
        return self.emit(
            value.kind, f"fneg double {value.text}" if value.kind == "double" else f"sub i64 0, {value.text}"
        )

    def of_Compare(self, names: Names, node: ast.Compare) -> Any:
        """a < b < c: all parts are evaluated, as they have no side effects."""
        values = [self.value(names, part) for part in (node.left, *node.comparators)]
        tests = [self.compared(sign, a, b) for sign, a, b in zip(node.ops, values, values[1:], strict=False)]
        result = tests[0]
        for test in tests[1:]:
            result = self.emit("i1", f"and i1 {self.text(result, 'i1')}, {self.text(test, 'i1')}")
        return result

    def compared(self, sign: ast.cmpop, left: Any, right: Any) -> Any:
        floats, integers, known = ORDER[type(sign)]
        if not isinstance(left, Value) and not isinstance(right, Value):
            return known(left, right)
        if _whole(left) and _whole(right):
            return self.emit("i1", f"icmp {integers} i64 {self.text(left, 'i64')}, {self.text(right, 'i64')}")
        return self.emit("i1", f"fcmp {floats} double {self.text(left, 'double')}, {self.text(right, 'double')}")

    def of_BoolOp(self, names: Names, node: ast.BoolOp) -> Any:
        """What comes second is looked at only where the first leaves it open: an index may be beyond the end."""
        place, (after,) = self.allocated("i1"), self.labels("after")
        for part in node.values:
            test = self.value(names, part)
            self.store(test if isinstance(test, Value) else bool(test), place)
            (more,) = self.labels("more")
            yes, no = (more, after) if isinstance(node.op, ast.And) else (after, more)
            self.branch(test, yes, no)
            self.start(more)
        self.jump(after)
        self.start(after)
        return self.load(place)

    def of_IfExp(self, names: Names, node: ast.IfExp) -> Any:
        test = self.value(names, node.test)
        if not isinstance(test, Value):
            return self.value(names, node.body if test else node.orelse)
        return self.chosen(test, self.value(names, node.body), self.value(names, node.orelse))

    def chosen(self, test: Value, yes: Any, no: Any) -> Value:
        kind = "i64" if _whole(yes) and _whole(no) else "double"
        return self.emit(kind, f"select i1 {test.text}, {kind} {self.text(yes, kind)}, {kind} {self.text(no, kind)}")

    def of_Call(self, names: Names, node: ast.Call) -> Any:
        given = [self.value(names, argument) for argument in node.args]
        return self.called(self.value(names, node.func), given)

    def called(self, function: Any, given: list[Any]) -> Any:
        if callable(function):
            return function(self, *given)
        if function in ("min", "max"):
            return self.extreme(function, given)
        if function in ROOTS:
            return self.emit("double", f"call double @{ROOTS[function]}(double {self.text(given[0], 'double')})")
        if function in LIBM or function in LIBM_OF_TWO:
            listed = ", ".join(f"double {self.text(x, 'double')}" for x in given)
            return self.emit("double", f"call double @{function}({listed})")
        if function == "len" and isinstance(given[0], tuple | Array):
            return len(given[0]) if isinstance(given[0], tuple) else given[0].length
        if function == "float":
            return Value("double", self.text(given[0], "double"))
        if function == "int":
            return self.emit("i64", f"fptosi double {self.text(given[0], 'double')} to i64")
        raise Untranslatable(f"call of {function}")

    def extreme(self, function: str, given: list[Any]) -> Any:
        """As Python does it: the first unless a later one is beyond; so min(1, nan) is 1."""
        result = given[0]
        for other in given[1:]:
            beyond = self.compared(ast.Lt() if function == "min" else ast.Gt(), other, result)
            known = other if beyond else result
            result = self.chosen(beyond, other, result) if isinstance(beyond, Value) else known
        return result


def _whole(value: Any) -> bool:
    return value.kind == "i64" if isinstance(value, Value) else isinstance(value, int)
