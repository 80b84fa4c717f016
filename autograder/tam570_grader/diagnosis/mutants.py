"""Slips in the syntax tree of a module, which make it wrong: the audit grades them, and feedback looks for them.

The operators are the mistakes that people make with formulas: a sign, a factor of two, a term dropped or counted
twice, sine for cosine, swapped arguments or indices, another exponent, a transposed product, a missing copy, the
wrong branch at the special case.
"""

import ast
import copy
import functools
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from typing import TypeVar

COUNTERPARTS = {
    "sin": "cos",
    "cos": "sin",
    "sinh": "cosh",
    "cosh": "sinh",
    "tan": "sin",
    "exp": "expm1",
    "arctan2": "arcsin",
    "min": "max",
    "max": "min",
    "minimum": "maximum",
    "maximum": "minimum",
}
OPPOSITES: dict[type[ast.AST], type[ast.AST]] = {
    ast.Add: ast.Sub,
    ast.Sub: ast.Add,
    ast.Mult: ast.Div,
    ast.Div: ast.Mult,
    ast.Lt: ast.LtE,
    ast.LtE: ast.Lt,
    ast.Gt: ast.GtE,
    ast.GtE: ast.Gt,
    ast.Eq: ast.NotEq,
    ast.NotEq: ast.Eq,
    ast.And: ast.Or,
    ast.Or: ast.And,
}
Node = TypeVar("Node", bound=ast.AST)
Operator = Callable[[ast.expr], Iterator[ast.expr]]
SYMMETRIC = {"dot", "hypot", "max", "maximum", "min", "minimum", "multiply"}  # functions of two arguments


@dataclass(frozen=True)
class Mutant:
    """One mutant of a function: what is wrong, the expressions before and after, and the function's text with it.

    product : the largest one that the expression is a factor of
    """

    operator: str
    was: ast.expr
    now: ast.expr
    text: str
    product: ast.expr


def mutants_of(source: str) -> dict[str, list[Mutant]]:
    """Make the mutants of each function of a module, and more too near to these to need a test of their own."""
    lines, mutants = source.splitlines(keepends=True), dict[str, list[Mutant]]()
    for function in (node for node in ast.parse(source).body if isinstance(node, ast.FunctionDef)):
        before = function.lineno - 1
        text = "\n" * before + "".join(lines[before : function.end_lineno])  # so that the lines keep their numbers
        products = _products(function)
        mutants[function.name] = [
            Mutant(operator, node, mutant, replaced(text, node, ast.unparse(mutant)), products.get(id(node), node))
            for node, operator, mutant in (*changed_expressions(function), *changed_expressions(function, MORE))
        ]
        mutants[function.name] += _everywhere(function)
    return mutants


def _products(function: ast.FunctionDef) -> dict[int, ast.expr]:
    """For each factor, by its id, the largest product that it is in."""
    products: dict[int, ast.expr] = {}
    for node in ast.walk(function):  # from the outside in
        if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Mult | ast.Div | ast.Pow):
            for factor in (node.left, node.right):
                products[id(factor)] = products.get(id(node), node)
    return products


def _everywhere(function: ast.FunctionDef) -> Iterator[Mutant]:
    """One slip in every place: each sine a cosine, each square a product."""
    for name, operator in EVERYWHERE:
        changer = _InEveryPlace(operator)
        changed = changer.visit(copy.deepcopy(function))
        if len(changer.places) > 1:
            places = ast.Tuple(changer.places)
            yield Mutant(name, places, places, ast.unparse(ast.fix_missing_locations(changed)), places)


class _InEveryPlace(ast.NodeTransformer):
    """Applies an operator to all expressions at once."""

    def __init__(self, operator: "Operator") -> None:
        self.operator, self.places = operator, list[ast.expr]()

    def visit(self, node: ast.AST) -> ast.AST:
        node = self.generic_visit(node)
        if isinstance(node, ast.expr) and (change := next(self.operator(node), None)):
            self.places.append(node)
            return change
        return node


@functools.lru_cache(maxsize=256)
def reached(text: str) -> dict[str, set[str]]:
    """For each function of a module those that it may come to call, itself among them."""
    body = ast.parse(text).body
    names_in = {node.name: names_used(node) for node in body if isinstance(node, ast.FunctionDef)}
    always = {
        name for node in body if not isinstance(node, ast.FunctionDef) for name in names_used(node) if name in names_in
    }  # what runs at import
    reach_of = {name: {name, *(names & names_in.keys()), *always} for name, names in names_in.items()}
    while True:
        wider = {name: set().union(*(reach_of[inner] for inner in reach)) for name, reach in reach_of.items()}
        if wider == reach_of:
            return reach_of
        reach_of = wider


def called(text: str, name: str) -> set[str]:
    """Return the names that a function of a module may come to use; none where the module has no such function."""
    reach = reached(text).get(name, set())
    nodes = (node for node in ast.parse(text).body if isinstance(node, ast.FunctionDef) and node.name in reach)
    return set().union(*map(names_used, nodes))


def names_used(node: ast.AST) -> set[str]:
    """Return the names in an expression or a statement."""
    return {inner.id for inner in ast.walk(node) if isinstance(inner, ast.Name)}


def replaced(source: str, node: ast.expr, text: str) -> str:
    """Return the source with other text in the place of an expression."""
    lines = source.encode().splitlines(keepends=True)
    assert node.end_lineno is not None and node.end_col_offset is not None
    start = sum(map(len, lines[: node.lineno - 1])) + node.col_offset
    end = sum(map(len, lines[: node.end_lineno - 1])) + node.end_col_offset
    joined = b"".join(lines)
    return (joined[:start] + f"({text})".encode() + joined[end:]).decode()


def changed_expressions(
    function: ast.FunctionDef, chosen: Mapping[str, Operator] | None = None
) -> Iterator[tuple[ast.expr, str, ast.expr]]:
    """Yield every expression of a body, and what an operator makes of it; messages and tolerances are no physics."""
    spared = {id(inner) for node in ast.walk(function) if _is_spared(node) for inner in ast.walk(node)}
    inputs = {argument.arg for argument in (*function.args.args, *function.args.kwonlyargs)}
    operators = chosen or {**OPERATORS, "a missing copy": partial(_copies, inputs=inputs)}
    for statement in function.body:
        for node in ast.walk(statement):
            if isinstance(node, ast.If) and not chosen:
                yield from ((node.test, "a branch", ast.Constant(always)) for always in (True, False))
            if isinstance(node, ast.expr) and id(node) not in spared:
                for name, operator in operators.items():
                    for change in operator(node):
                        yield node, name, change


def _is_spared(node: ast.AST) -> bool:
    return isinstance(node, ast.Raise) or (isinstance(node, ast.keyword) and node.arg == "rtol")


def _signs(node: ast.expr) -> Iterator[ast.expr]:
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub | ast.Not):
        yield node.operand


def _operations(node: ast.expr) -> Iterator[ast.expr]:
    """Change an operation: a + b to a - b, a, b and a + 2 b; a * b to a / b; A @ B to B @ A and A.T @ B."""
    if not isinstance(node, ast.BinOp):
        return
    if type(node.op) in OPPOSITES:
        yield _with(node, op=OPPOSITES[type(node.op)]())
    if isinstance(node.op, ast.Add | ast.Sub):
        yield from (node.left, node.right, _with(node, right=_times(2, node.right)))
    if isinstance(node.op, ast.MatMult):
        yield _with(node, left=node.right, right=node.left)
        yield _with(node, left=ast.Attribute(node.left, "T", ast.Load()))


def _exponents(node: ast.expr) -> Iterator[ast.expr]:
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Pow) and isinstance(node.right, ast.Constant):
        yield _with(node, right=ast.Constant(_number(node.right) + 1))
        yield _with(node, right=ast.Constant(_number(node.right) - 1))


def _factors(node: ast.expr) -> Iterator[ast.expr]:
    """Yield a number becomes twice and half of itself."""
    if (
        isinstance(node, ast.Constant)
        and isinstance(node.value, int | float)
        and not isinstance(node.value, bool)
        and node.value
    ):
        yield ast.Constant(2 * node.value)
        if isinstance(node.value, float):
            yield ast.Constant(node.value / 2)


def _counterparts(node: ast.expr) -> Iterator[ast.expr]:
    """sin becomes cos, and so on."""
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr in COUNTERPARTS:
        yield _with(node, func=_with(node.func, attr=COUNTERPARTS[node.func.attr]))


def _counterpart_of(name: str, node: ast.expr) -> Iterator[ast.expr]:
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == name:
        yield from _counterparts(node)


def _copies(node: ast.expr, inputs: set[str]) -> Iterator[ast.expr]:
    """Yield a copy of an input becomes the input."""
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
        if node.func.attr == "array" and len(node.args) == 1 and getattr(node.args[0], "id", None) in inputs:
            yield node.args[0]
        if node.func.attr == "copy" and not node.args:
            yield node.func.value


def _arguments(node: ast.expr) -> Iterator[ast.expr]:
    """Neighbouring arguments, or parts of a tuple, change places."""
    if isinstance(node, ast.Call) and _name_of(node.func) in SYMMETRIC:
        return
    for field in ("args", "elts"):
        parts = getattr(node, field, [])
        if isinstance(node, ast.Lambda) or any(isinstance(part, ast.Slice) for part in parts):
            continue  # A[:, 1] is no tuple
        if isinstance(node, ast.Call | ast.Tuple | ast.List) and isinstance(getattr(node, "ctx", ast.Load()), ast.Load):
            for i in range(len(parts) - 1):
                if not _equal(parts[i], parts[i + 1]):
                    yield _with(node, **{field: [*parts[:i], parts[i + 1], parts[i], *parts[i + 2 :]]})


def _equal(first: ast.expr, other: ast.expr) -> bool:
    return isinstance(first, ast.Constant) and isinstance(other, ast.Constant) and first.value == other.value


def _indices(node: ast.expr) -> Iterator[ast.expr]:
    if isinstance(node, ast.Subscript) and isinstance(node.slice, ast.Constant) and isinstance(node.ctx, ast.Load):
        index = node.slice.value
        if isinstance(index, int):
            yield _with(node, slice=ast.Constant(index - 1 if index else 1))


def _transposes(node: ast.expr) -> Iterator[ast.expr]:
    if isinstance(node, ast.Attribute) and node.attr == "T":
        yield node.value


def _conditions(node: ast.expr) -> Iterator[ast.expr]:
    """< becomes <=, and becomes or; a choice takes the other branch always."""
    if isinstance(node, ast.Compare) and len(node.ops) == 1 and type(node.ops[0]) in OPPOSITES:
        yield _with(node, ops=[OPPOSITES[type(node.ops[0])]()])
    if isinstance(node, ast.BoolOp):
        yield _with(node, op=OPPOSITES[type(node.op)]())
    if isinstance(node, ast.IfExp):
        yield from (node.body, node.orelse)


OPERATORS: dict[str, Operator] = {
    "a sign": _signs,
    "a term or product": _operations,
    "an exponent": _exponents,
    "a factor": _factors,
    "another function": _counterparts,
    "swapped arguments": _arguments,
    "an index": _indices,
    "a transpose": _transposes,
    "a condition": _conditions,
}


def _missing_factors(node: ast.expr) -> Iterator[ast.expr]:
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Mult | ast.Div):
        yield node.left
        if isinstance(node.op, ast.Mult):
            yield node.right


def _first_signs(node: ast.expr) -> Iterator[ast.expr]:
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add | ast.Sub):
        yield _with(node, left=ast.UnaryOp(ast.USub(), node.left))


def _numbers(node: ast.expr) -> Iterator[ast.expr]:
    """Yield a number becomes another of those that formulas have: 1/3 for 1/12, 2/5 for 1/2."""
    if isinstance(node, ast.Constant) and isinstance(node.value, int | float) and not isinstance(node.value, bool):
        yield from (ast.Constant(node.value * ratio) for ratio in RATIOS if node.value)


def _linearised(node: ast.expr) -> Iterator[ast.expr]:
    """sin x becomes x, and cos x 1."""
    if isinstance(node, ast.Call) and len(node.args) == 1 and _name_of(node.func) in ("sin", "cos", "tan"):
        yield ast.Constant(1.0) if _name_of(node.func) == "cos" else node.args[0]


def _products_for_squares(node: ast.expr) -> Iterator[ast.expr]:
    """om1**2 and om1 * om1 become om1 * om2."""
    if isinstance(node, ast.BinOp) and _is_square(node):
        yield from (ast.BinOp(node.left, ast.Mult(), other) for other in _other(node.left))
    elif isinstance(node, ast.BinOp) and isinstance(node.op, ast.Mult):
        last = node.left.right if isinstance(node.left, ast.BinOp) else node.left
        if ast.dump(last) == ast.dump(node.right):
            yield from (_with(node, right=other) for other in _other(node.right))


def _other(node: ast.expr) -> Iterator[ast.expr]:
    """Yield the second of two quantities for the first, as their names have it, and the first for the second."""
    if isinstance(node, ast.Name) and node.id[-1:] in "12":
        yield ast.Name(node.id[:-1] + "21"[int(node.id[-1]) - 1], ast.Load())


def _missing_squares(node: ast.expr) -> Iterator[ast.expr]:
    """hypot(a, b) loses the square of b, and a**2 + b**2 that of its size."""
    if isinstance(node, ast.Call) and _name_of(node.func) == "hypot" and len(node.args) == 2:
        first, second = node.args
        total = ast.BinOp(ast.BinOp(first, ast.Mult(), first), ast.Add(), second)
        yield ast.BinOp(total, ast.Pow(), ast.Constant(0.5))
    if (
        isinstance(node, ast.BinOp)
        and isinstance(node.op, ast.Add)
        and _is_square(node.left)
        and _is_square(node.right)
    ):
        yield ast.BinOp(node, ast.Pow(), ast.Constant(0.5))


def _is_square(node: ast.expr) -> bool:
    return isinstance(node, ast.BinOp) and isinstance(node.op, ast.Pow) and _equal(node.right, ast.Constant(2))


RATIOS = 2 / 3, 3 / 2, 1 / 3, 3, 1 / 4, 4, 1 / 6, 6, 3 / 4, 4 / 3
MORE: dict[str, Operator] = {
    "a missing factor": _missing_factors,
    "a first sign": _first_signs,
    "a number": _numbers,
    "linearised": _linearised,
    "a product for a square": _products_for_squares,
    "a missing square": _missing_squares,
}
EVERYWHERE: tuple[tuple[str, Operator], ...] = (
    *(("another function", partial(_counterpart_of, name)) for name in ("sin", "cos")),
    ("linearised", _linearised),
    ("a product for a square", _products_for_squares),
)


def _with(node: Node, **fields: object) -> Node:
    """Return a copy of the node, but for these fields."""
    changed = copy.copy(node)
    for name, value in fields.items():
        setattr(changed, name, value)
    return changed


def _times(number: int, node: ast.expr) -> ast.expr:
    return ast.BinOp(ast.Constant(number), ast.Mult(), node)


def _name_of(function: ast.expr) -> str:
    return getattr(function, "attr", getattr(function, "id", ""))


def _number(node: ast.Constant) -> float:
    assert isinstance(node.value, int | float)
    return node.value
