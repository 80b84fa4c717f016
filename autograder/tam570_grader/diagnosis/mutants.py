"""Slips in the syntax tree of a module that make it wrong: the audit grades them, and diagnosis searches them.

The operators are the mistakes that people make with formulas: a sign, a factor of two, a term dropped or counted
twice, sine for cosine, swapped arguments or indices, another exponent, a transposed product, a missing copy, the
wrong branch at the special case.
"""

import ast
import copy
import functools
import math
from collections.abc import Callable, Iterator, Mapping, Sequence, Set
from dataclasses import dataclass
from functools import partial
from itertools import combinations, product
from typing import TypeVar

from tam570.checking.transforms import LENGTHS

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
SYMMETRIC = {"dot", "hypot", "max", "maximum", "min", "minimum", "multiply"}  # functions of two arguments in any order


@dataclass(frozen=True)
class Mutant:
    """A mutant of a function: its operator, the expressions before and after, and the function's changed source.

    product : the largest product that has the expression as a factor
    """

    operator: str
    was: ast.expr
    now: ast.expr
    text: str
    product: ast.expr


def mutants_of(source: str) -> dict[str, list[Mutant]]:
    """Return the mutants of each function of a module: those of `OPERATORS`, which the audit grades, and of `MORE`."""
    lines, mutants = source.splitlines(keepends=True), dict[str, list[Mutant]]()
    functions = [node for node in ast.parse(source).body if isinstance(node, ast.FunctionDef)]
    public = {function.name for function in functions if function.name[0] != "_"}
    for function in functions:
        before = function.lineno - 1
        text = "\n" * before + "".join(lines[before : function.end_lineno])  # so that the lines keep their numbers
        products = _products(function)
        mutants[function.name] = [
            Mutant(operator, node, mutant, replaced(text, node, ast.unparse(mutant)), products.get(id(node), node))
            for node, operator, mutant in (
                *changed_expressions(function),
                *changed_expressions(function, MORE | _of_quantities(function, public)),
            )
        ]
        mutants[function.name] += _everywhere(function)
    return mutants


def _products(function: ast.FunctionDef) -> dict[int, ast.expr]:
    """Return the largest product that contains each factor, by the factor's id."""
    products: dict[int, ast.expr] = {}
    for node in ast.walk(function):  # from the outside in
        if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Mult | ast.Div | ast.Pow):
            for factor in (node.left, node.right):
                products[id(factor)] = products.get(id(node), node)
    return products


def _of_quantities(function: ast.FunctionDef, public: Set[str]) -> dict[str, "Operator"]:
    """Return the operators that depend on the function's other names, such as one quantity for another."""
    inputs = {argument.arg for argument in (*function.args.args, *function.args.kwonlyargs)}
    groups, raw, computed = [inputs.intersection(LENGTHS)], dict[str, str](), set[int]()
    for node in ast.walk(function):
        if isinstance(node, ast.Assign) and len(node.targets) == 1:
            (target,) = node.targets
            tuples = (each for each in ast.walk(target) if isinstance(each, ast.Tuple))
            groups += [{part.id for part in each.elts if isinstance(part, ast.Name)} for each in tuples]
            computed |= {id(value) for value in getattr(node.value, "elts", [node.value])}
            vector = getattr(getattr(node.value, "left", None), "id", "")  # r in r / norm(r)
            value = node.value.right if isinstance(node.value, ast.BinOp) and vector else node.value
            if isinstance(target, ast.Name) and isinstance(value, ast.Call) and len(value.args) == 1:
                argument = getattr(value.args[0], "id", "")
                if vector in ("", argument):
                    raw[target.id] = argument
                    inputs |= {vector} - {""}
    groups = [group for group in groups if 2 <= len(group) <= MOST_ALIKE]
    raw = {name: argument for name, argument in raw.items() if argument in inputs - {name}}
    return {
        "another quantity": partial(_others_of_a_kind, groups=groups),
        "two exchanged": partial(_exchanged_in_a_sum, groups=groups),
        "sine and cosine": partial(_exchanged_in_a_sum, groups=()),
        "as given": partial(_as_given, raw=raw),
        "ignored": partial(_ignored, computed=computed),
        "a multiple": partial(_multiples, computed=computed, public=public),
        "a factor of a term": partial(_other_powers, names=names_used(function) & {"mass", "curvature", *LENGTHS}),
    }


def _as_given(node: ast.expr, raw: Mapping[str, str]) -> Iterator[ast.expr]:
    """Yield the argument in place of a name that is computed from it."""
    if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load) and node.id in raw:
        yield ast.Name(raw[node.id], ast.Load())


def _ignored(node: ast.expr, computed: Set[int]) -> Iterator[ast.expr]:
    """Yield zero in place of a product that is assigned to a name."""
    if id(node) in computed and isinstance(node, ast.BinOp) and isinstance(node.op, ast.Mult):
        yield ast.Constant(0.0)


def _multiples(node: ast.expr, computed: Set[int], public: Set[str]) -> Iterator[ast.expr]:
    """Yield the result of another public function, if it is assigned to a name, doubled and halved."""
    if id(node) in computed and isinstance(node, ast.Call) and _name_of(node.func) in public:
        yield from (_times(2, node), _times(0.5, node))


def _others_of_a_kind(node: ast.expr, groups: Sequence[Set[str]]) -> Iterator[ast.expr]:
    """Yield the other names of a group: C in place of A if `A, C = inertia`, or the offset in place of the radius."""
    if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load):
        others = {other for group in groups if node.id in group for other in group - {node.id}}
        yield from (ast.Name(other, ast.Load()) for other in sorted(others))


def _other_powers(node: ast.expr, names: Set[str]) -> Iterator[ast.expr]:
    """Yield the sum with one of its two terms multiplied or divided by a mass, a curvature or a length."""
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add | ast.Sub):
        for side, name, op in product(("left", "right"), sorted(names), (ast.Mult(), ast.Div())):
            yield _with(node, **{side: ast.BinOp(getattr(node, side), op, ast.Name(name, ast.Load()))})


def _exchanged_in_a_sum(node: ast.expr, groups: Sequence[Set[str]]) -> Iterator[ast.expr]:
    """Yield p cos + q sin in place of p sin + q cos, for calls or for names of one group."""
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add | ast.Sub):
        names, calls = names_used(node), {_name_of(each.func) for each in ast.walk(node) if isinstance(each, ast.Call)}
        pairs = [pair for group in groups for pair in combinations(sorted(group & names), 2)]
        for first, other in pairs if groups else [("sin", "cos")] if {"sin", "cos"} <= calls else []:
            yield _Renamed({first: other, other: first}).visit(copy.deepcopy(node))


class _Renamed(ast.NodeTransformer):
    """Renames variables and functions of modules."""

    def __init__(self, names: Mapping[str, str]) -> None:
        self.names = names

    def visit_Name(self, node: ast.Name) -> ast.expr:  # noqa: N802
        return _with(node, id=self.names.get(node.id, node.id))

    def visit_Attribute(self, node: ast.Attribute) -> ast.expr:  # noqa: N802
        return _with(node, value=self.visit(node.value), attr=self.names.get(node.attr, node.attr))


def _everywhere(function: ast.FunctionDef) -> Iterator[Mutant]:
    """Yield mutants with a slip in every place: each sine a cosine, each square a product; or only of one angle."""
    expressions = [node for node in ast.walk(function) if isinstance(node, ast.expr)]
    calls = [node for node in expressions if isinstance(node, ast.Call) and len(node.args) == 1]
    angles = {ast.dump(node.args[0]) for node in calls if _name_of(node.func) in ("sin", "cos")}
    of_angles: list[tuple[str, Operator]] = [
        ("sine and cosine", partial(_sines_and_cosines, ("sin", "cos"), angle)) for angle in (None, *sorted(angles))
    ]
    for name, operator in (*EVERYWHERE, *of_angles):
        if not any(map(any, map(operator, expressions))):  # faster than to copy the function first
            continue
        changer = _InEveryPlace(operator)
        changed = changer.visit(function)
        if len(changer.places) > 1:
            places = ast.Tuple(changer.places)
            yield Mutant(name, places, places, ast.unparse(ast.fix_missing_locations(changed)), places)


class _InEveryPlace(ast.NodeTransformer):
    """Applies an operator to all expressions of a copy."""

    def __init__(self, operator: "Operator") -> None:
        self.operator, self.places = operator, list[ast.expr]()

    def visit(self, node: ast.AST) -> ast.AST:
        lists = {name: [*field] for name, field in ast.iter_fields(node) if isinstance(field, list)}
        node = self.generic_visit(_with(node, **lists))
        if isinstance(node, ast.expr) and (change := next(self.operator(node), None)):
            self.places.append(node)
            return change
        return node


@functools.lru_cache(maxsize=256)
def reached(text: str) -> dict[str, set[str]]:
    """Return, for each function of a module, all functions that it may call, directly or not, and itself."""
    body = ast.parse(text).body
    names_in = {node.name: names_used(node) for node in body if isinstance(node, ast.FunctionDef)}
    always = {
        name for node in body if not isinstance(node, ast.FunctionDef) for name in names_used(node) if name in names_in
    }  # names used at import
    reach_of = {name: {name, *(names & names_in.keys()), *always} for name, names in names_in.items()}
    while True:
        wider = {name: set().union(*(reach_of[inner] for inner in reach)) for name, reach in reach_of.items()}
        if wider == reach_of:
            return reach_of
        reach_of = wider


def names_reached(text: str, name: str) -> set[str]:
    """Return the names that a function of a module and those that it calls use; empty if there is no such function."""
    reach = reached(text).get(name, set())
    nodes = (node for node in ast.parse(text).body if isinstance(node, ast.FunctionDef) and node.name in reach)
    return set().union(*map(names_used, nodes))


def names_used(node: ast.AST) -> set[str]:
    """Return the names in an expression or a statement."""
    return {inner.id for inner in ast.walk(node) if isinstance(inner, ast.Name)}


def replaced(source: str, node: ast.expr, text: str) -> str:
    """Return the source with an expression replaced by a text."""
    lines = source.encode().splitlines(keepends=True)
    assert node.end_lineno is not None and node.end_col_offset is not None
    start = sum(map(len, lines[: node.lineno - 1])) + node.col_offset
    end = sum(map(len, lines[: node.end_lineno - 1])) + node.end_col_offset
    joined = b"".join(lines)
    return (joined[:start] + f"({text})".encode() + joined[end:]).decode()


def changed_expressions(
    function: ast.FunctionDef, chosen: Mapping[str, Operator] | None = None
) -> Iterator[tuple[ast.expr, str, ast.expr]]:
    """Yield each expression of a body, an operator's name and its result; leave out messages and tolerances.

    chosen : operators other than `OPERATORS`; these do not change constants in an index
    """
    spared = set[int]()
    for node in ast.walk(function):
        if isinstance(node, ast.Raise) or (isinstance(node, ast.keyword) and node.arg == "rtol"):
            spared |= {id(inner) for inner in ast.walk(node)}
        if isinstance(node, ast.Subscript) and chosen:
            spared |= {id(inner) for inner in ast.walk(node.slice) if isinstance(inner, ast.Constant)}
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


def _signs(node: ast.expr) -> Iterator[ast.expr]:
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub | ast.Not):
        yield node.operand


def _operations(node: ast.expr) -> Iterator[ast.expr]:
    """Yield a - b, a, b and a + 2 b in place of a + b; a / b of a * b; B @ A and A.T @ B of A @ B."""
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
        power = ast.literal_eval(node.right)
        yield from (_with(node, right=ast.Constant(other)) for other in (power + 1, power - 1))


def _factors(node: ast.expr) -> Iterator[ast.expr]:
    """Yield the number doubled and, for a float, halved."""
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
    """Yield a call of the counterpart, such as cos in place of sin."""
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr in COUNTERPARTS:
        yield _with(node, func=_with(node.func, attr=COUNTERPARTS[node.func.attr]))


def _sines_and_cosines(names: Sequence[str], angle: str | None, node: ast.expr) -> Iterator[ast.expr]:
    """Yield cosine in place of sine, or sine in place of cosine, of one angle or, for None, of any."""
    if not isinstance(node, ast.Call) or _name_of(node.func) not in names or len(node.args) != 1:
        return
    if angle in (None, ast.dump(node.args[0])):
        yield from _counterparts(node)


def _copies(node: ast.expr, inputs: set[str]) -> Iterator[ast.expr]:
    """Yield the input in place of its copy."""
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
        if node.func.attr == "array" and len(node.args) == 1 and getattr(node.args[0], "id", None) in inputs:
            yield node.args[0]
        if node.func.attr == "copy" and not node.args:
            yield node.func.value


def _arguments(node: ast.expr) -> Iterator[ast.expr]:
    """Yield the call or tuple with two neighbouring arguments or elements exchanged."""
    if isinstance(node, ast.Call) and _name_of(node.func) in SYMMETRIC:
        return
    for field in ("args", "elts"):
        parts = getattr(node, field, [])
        if isinstance(node, ast.Lambda) or any(isinstance(part, ast.Slice) for part in parts):
            continue  # A[:, 1] is not a tuple
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
    """Yield <= in place of <, or in place of and; each branch in place of a conditional expression."""
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
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Mult | ast.MatMult | ast.Div):
        yield node.left
        if not isinstance(node.op, ast.Div):
            yield node.right


def _half_terms(node: ast.expr) -> Iterator[ast.expr]:
    """Yield a + b/2 and a/2 + b in place of a + b."""
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add | ast.Sub):
        yield from (_with(node, right=_times(0.5, node.right)), _with(node, left=_times(0.5, node.left)))


def _other_indices(node: ast.expr) -> Iterator[ast.expr]:
    """Yield the third component in place of the first or second; `_indices` yields the others."""
    if isinstance(node, ast.Subscript) and isinstance(node.slice, ast.Constant) and node.slice.value in (0, 1):
        yield _with(node, slice=ast.Constant(2))


def _first_signs(node: ast.expr) -> Iterator[ast.expr]:
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add | ast.Sub):
        yield _with(node, left=ast.UnaryOp(ast.USub(), node.left))


def _signs_of_components(node: ast.expr) -> Iterator[ast.expr]:
    """Yield the list or tuple with the sign of one computed element reversed."""
    if isinstance(node, ast.List | ast.Tuple) and isinstance(node.ctx, ast.Load):
        for k, component in enumerate(node.elts):
            if isinstance(component, ast.BinOp | ast.Call) and not any(
                isinstance(part, ast.Slice) for part in node.elts
            ):
                yield _with(node, elts=[*node.elts[:k], ast.UnaryOp(ast.USub(), component), *node.elts[k + 1 :]])


def _numbers(node: ast.expr) -> Iterator[ast.expr]:
    """Yield the number times ratios of numbers in formulas, such as 4: 1/3 in place of 1/12."""
    if isinstance(node, ast.Constant) and isinstance(node.value, int | float) and not isinstance(node.value, bool):
        yield from (ast.Constant(node.value * ratio) for ratio in RATIOS if node.value)


def _linearised(node: ast.expr) -> Iterator[ast.expr]:
    """Yield x in place of sin x and tan x, and 1 in place of cos x."""
    if isinstance(node, ast.Call) and len(node.args) == 1 and _name_of(node.func) in ("sin", "cos", "tan"):
        yield ast.Constant(1.0) if _name_of(node.func) == "cos" else node.args[0]


def _products_for_squares(node: ast.expr) -> Iterator[ast.expr]:
    """Yield om1 * om2 in place of om1**2 and om1 * om1."""
    if isinstance(node, ast.BinOp) and _is_square(node):
        yield from (ast.BinOp(node.left, ast.Mult(), other) for other in _other(node.left))
    elif isinstance(node, ast.BinOp) and isinstance(node.op, ast.Mult):
        last = node.left.right if isinstance(node.left, ast.BinOp) else node.left
        if ast.dump(last) == ast.dump(node.right):
            yield from (_with(node, right=other) for other in _other(node.right))


def _other(node: ast.expr) -> Iterator[ast.expr]:
    """Yield the second of two quantities in place of the first, by the digit in its name, or the reverse."""
    if isinstance(node, ast.Name) and node.id[-1:] in "12":
        yield ast.Name(node.id[:-1] + "21"[int(node.id[-1]) - 1], ast.Load())


def _missing_squares(node: ast.expr) -> Iterator[ast.expr]:
    """Yield sqrt(a**2 + b) in place of hypot(a, b), and sqrt(a**2 + b**2) in place of a**2 + b**2."""
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


def _squares_of_sums(node: ast.expr) -> Iterator[ast.expr]:
    """Yield (a + b)**2 in place of a**2 + b**2, and (1 + b)**2 in place of 1 + b**2."""
    if not (isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add) and _is_square(node.right)):
        return
    if _is_square(node.left) or _equal(node.left, ast.Constant(1)):
        first, second = (getattr(side, "left", side) for side in (node.left, node.right))
        yield _with(node.right, left=ast.BinOp(first, ast.Add(), second))


def _lost_signs(node: ast.expr) -> Iterator[ast.expr]:
    """Yield |sin x| and |cos x| in place of sin x and cos x."""
    if isinstance(node, ast.Call) and len(node.args) == 1 and _name_of(node.func) in ("sin", "cos"):
        yield ast.Call(ast.Name("abs", ast.Load()), [node], [])


def _is_square(node: ast.expr) -> bool:
    return isinstance(node, ast.BinOp) and isinstance(node.op, ast.Pow) and _equal(node.right, ast.Constant(2))


def _missing_first_terms(node: ast.expr) -> Iterator[ast.expr]:
    """Yield -b in place of a - b."""
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Sub):
        yield ast.UnaryOp(ast.USub(), node.right)


def _missing_components(node: ast.expr) -> Iterator[ast.expr]:
    """Yield the list or tuple with one computed element replaced by zero."""
    if not isinstance(node, ast.List | ast.Tuple) or not isinstance(node.ctx, ast.Load):
        return
    if not any(isinstance(part, ast.Slice) for part in node.elts):
        for k, component in enumerate(node.elts):
            if not isinstance(component, ast.Constant | ast.Name | ast.Starred | ast.Tuple | ast.List):
                yield _with(node, elts=[*node.elts[:k], _times(0, component), *node.elts[k + 1 :]])


def _tangents(node: ast.expr) -> Iterator[ast.expr]:
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr in ("sin", "cos"):
        yield _with(node, func=_with(node.func, attr="tan"))


def _roots(node: ast.expr) -> Iterator[ast.expr]:
    """Yield x in place of sqrt(x), and a / sqrt(b) and a / b**2 of a / b; `_exponents` changes powers."""
    if isinstance(node, ast.Call) and _name_of(node.func) == "sqrt" and len(node.args) == 1:
        yield node.args[0]
    divisor = node.right if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Div) else None
    is_power = isinstance(divisor, ast.BinOp) and isinstance(divisor.op, ast.Pow)
    if divisor and not (
        is_power or isinstance(divisor, ast.Constant) or _name_of(getattr(divisor, "func", divisor)) == "sqrt"
    ):
        yield from (_with(node, right=ast.BinOp(divisor, ast.Pow(), ast.Constant(power))) for power in (0.5, 2))


def _frequencies(node: ast.expr) -> Iterator[ast.expr]:
    """Yield the root, as a circular frequency, divided by 2 pi."""
    if isinstance(node, ast.Call) and _name_of(node.func) == "sqrt":
        yield ast.BinOp(node, ast.Div(), ast.Constant(2 * math.pi))


def _norms(node: ast.expr) -> Iterator[ast.expr]:
    """Yield the sum of the absolute components in place of the norm of a vector."""
    if not (isinstance(node, ast.Call) and len(node.args) == 1):
        return
    name, (vector,) = _name_of(node.func), node.args
    if name == "sqrt" and isinstance(vector, ast.BinOp) and isinstance(vector.op, ast.MatMult):
        vector = vector.left if ast.dump(vector.left) == ast.dump(vector.right) else vector
    elif name == "hypot" and isinstance(vector, ast.Starred):
        vector = vector.value
    elif name != "norm":
        return
    size = ast.Call(ast.Name("abs", ast.Load()), [vector], [])
    yield ast.Call(ast.Name("sum", ast.Load()), [size], [])


def _degrees(node: ast.expr) -> Iterator[ast.expr]:
    """Yield 90 in place of pi / 2, and the sine of an angle in degrees."""
    yield from _other_angles(180 / math.pi, node)
    yield from _other_sines(180 / math.pi, node)


def _other_sines(factor: float, node: ast.expr) -> Iterator[ast.expr]:
    if isinstance(node, ast.Call) and len(node.args) == 1 and _name_of(node.func) in ("sin", "cos", "tan"):
        yield _with(node, args=[_times(factor, node.args[0])])


def _other_angles(factor: float, node: ast.expr) -> Iterator[ast.expr]:
    """Yield a share of pi times the factor, such as pi / 4 or -pi / 2 in place of pi / 2."""
    if _is_angle(node):
        yield _times(factor, node)


def _is_angle(node: ast.expr) -> bool:
    """Return whether an expression is a multiple or a fraction of pi."""
    if not (isinstance(node, ast.BinOp) and isinstance(node.op, ast.Mult | ast.Div)):
        return False
    sides = node.left, node.right
    return any(_name_of(side) == "pi" for side in sides) and any(isinstance(side, ast.Constant) for side in sides)


def _axes(node: ast.expr) -> Iterator[ast.expr]:
    """Yield "x" and "y" in place of "z", and so on."""
    if isinstance(node, ast.Constant) and node.value in ("x", "y", "z"):
        yield from (ast.Constant(axis) for axis in "xyz" if axis != node.value)


def _tangent_parts(node: ast.expr) -> Iterator[ast.expr]:
    """Yield arctan2 with its first or second argument doubled: twice or half the tangent."""
    if isinstance(node, ast.Call) and _name_of(node.func) in ("arctan2", "atan2") and len(node.args) == 2:
        first, second = node.args
        yield from (_with(node, args=parts) for parts in ([_times(2, first), second], [first, _times(2, second)]))


def _other_thirds(factor: float, node: ast.expr) -> Iterator[ast.expr]:
    """Yield x / 3, as in a bar's inertia about its end, times the factor: 7/12, 1/12 or 1/4 of x."""
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Div) and getattr(node.right, "value", 0) == 3:
        yield _times(factor, node)


def _halves(node: ast.expr) -> Iterator[ast.expr]:
    """Yield x in place of x / 2, and 1 in place of 0.5."""
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Div) and getattr(node.right, "value", 0) == 2:
        yield node.left
    elif isinstance(node, ast.Constant) and node.value == 0.5:
        yield ast.Constant(1.0)


MOST_ALIKE = 3  # names in a group; more names, as in a state, have different meanings
RATIOS = 2 / 3, 3 / 2, 1 / 3, 3, 1 / 4, 4, 1 / 6, 6, 3 / 4, 4 / 3
MORE: dict[str, Operator] = {
    "a missing factor": _missing_factors,
    "half a term": _half_terms,
    "another index": _other_indices,
    "a first sign": _first_signs,
    "the sign of a component": _signs_of_components,
    "a number": _numbers,
    "linearised": _linearised,
    "a product for a square": _products_for_squares,
    "a missing square": _missing_squares,
    "a square of a sum": _squares_of_sums,
    "a lost sign": _lost_signs,
    "a missing first term": _missing_first_terms,
    "a missing component": _missing_components,
    "a tangent": _tangents,
    "a root": _roots,
    "a frequency": _frequencies,
    "a norm": _norms,
    "degrees": _degrees,
    "radians": partial(_other_sines, math.pi / 180),
    "the sign of an angle": partial(_other_angles, -1.0),
    "an axis": _axes,
    "parts of a tangent": _tangent_parts,
    "the parallel axis": partial(_other_thirds, 7 / 4),
    "about the mass centre": partial(_other_thirds, 1 / 4),
    "without its turning": partial(_other_thirds, 3 / 4),
}
EVERYWHERE: tuple[tuple[str, Operator], ...] = (
    *(("another function", partial(_sines_and_cosines, (name,), None)) for name in ("sin", "cos")),
    ("linearised", _linearised),
    ("a product for a square", _products_for_squares),
    ("degrees", _degrees),
    ("radians", partial(_other_sines, math.pi / 180)),
    ("half an angle", partial(_other_angles, 0.5)),
    ("halves", _halves),
)


def _with(node: Node, **fields: object) -> Node:
    """Return a copy of the node with these fields changed."""
    return type(node)(**{**vars(node), **fields})  # copy.copy takes five times as long


def _times(number: float, node: ast.expr) -> ast.expr:
    return ast.BinOp(ast.Constant(number), ast.Mult(), node)


def _name_of(function: ast.expr) -> str:
    return getattr(function, "attr", getattr(function, "id", ""))
