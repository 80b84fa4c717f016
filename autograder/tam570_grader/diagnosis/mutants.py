"""Mutants of a module: slips in its syntax tree that make it wrong. The audit grades them, and diagnosis searches them.

The operators are the mistakes that people make with formulas: a sign, a factor of two, a term dropped or counted
twice, sine for cosine, swapped arguments or indices, another exponent, a transposed product, a missing copy, the
wrong branch at the special case. Each operator yields its edits of an expression, with the words for students. To add
one, add a `rule` to `MORE`, or to `OPERATORS` if the audit is to make its mutants, too.
"""

import ast
import copy
import functools
import math
from collections.abc import Callable, Container, Iterable, Iterator, Mapping, Sequence, Set
from dataclasses import dataclass
from functools import partial
from itertools import combinations, pairwise, permutations, product
from typing import Any, TypeGuard, TypeVar

from tam570.checking.transforms import LENGTHS

COUNTERPARTS = {
    **dict(sin="cos", cos="sin", sinh="cosh", cosh="sinh", tan="sin", exp="expm1", arctan2="arcsin"),
    **dict(min="max", max="min", minimum="maximum", maximum="minimum"),
}
PAIRS = (ast.Lt, ast.LtE), (ast.Gt, ast.GtE), (ast.Eq, ast.NotEq), (ast.And, ast.Or)
OPPOSITES: dict[type[ast.AST], type[ast.AST]] = {first: other for pair in PAIRS for first, other in (pair, pair[::-1])}
SYMMETRIC = {"dot", "hypot", "max", "maximum", "min", "minimum", "multiply"}  # functions of two arguments in any order
MOST_ALIKE = 3  # names in a group; more names, as in a state, have different meanings
RATIOS = 2 / 3, 3 / 2, 1 / 3, 3, 1 / 4, 4, 1 / 6, 6, 3 / 4, 4 / 3

# Words of several operators, or of more than one module
SIGN = "the sign of a term{} is reversed"
MISSING_TERM, MISSING_FACTOR = "a term{} is missing", "a factor{} is missing"
TWICE_OR_HALF = "a number{} is twice or half the right one"
EXCHANGED = "two quantities{} are exchanged, or their signs reversed"
COMPONENT = "the wrong component is used{}"
OTHER_FUNCTION = "the wrong function is used{}, such as sine for cosine"
SINE_AND_COSINE = "sine and cosine{} are exchanged"
TRANSPOSED = "matrices{} are multiplied in the wrong order, or one is transposed"
EVERY_HALF = "every division by 2 is missing"


@dataclass(frozen=True)
class Edit:
    """What an operator makes of an expression, and what a student reads of it.

    now       : the expression in its place
    words     : what the student did; {} becomes "with" the names in the term; "": only the audit makes this edit
    term      : the term that the words are about; None: the whole expression
    exact     : better words if the term is short: {term} as a student may have written it, and the names {beside} it
    rank      : students read of it only if no mutant of a lower rank explains the calls
    gives_way : 1, 2, 3: if mutants with other words explain the calls, too, these are named; in this order; 0: never
    """

    now: ast.expr
    words: str = ""
    term: ast.expr | None = None
    exact: str = ""
    rank: int = 1
    gives_way: int = 0


@dataclass(frozen=True)
class Mutant:
    """A mutant of a function that has words.

    term    : the term that the words are about
    product : the largest product that has the changed expression as a factor, or this expression
    text    : the changed source of the function
    """

    function: str
    edit: Edit
    term: ast.expr
    product: ast.expr
    text: str


Node = TypeVar("Node", bound=ast.AST)
Operator = Callable[[ast.expr], Iterable[Edit]]
Code = Any  # a part of a syntax tree: a node, a list of nodes, or a name
Wording = str | Callable[[ast.expr], str]  # for any term, or of a term


def rule(right: str, wrong: str, words: Wording = "", term: str = "", rank: int = 1, gives_way: int = 0) -> Operator:
    """Return the operator that yields the wrong code in place of the right one; capital letters are any expressions.

    The same letter is the same expression, NUMBER a number, and IT the whole expression. A function, such as `sin`, may
    be that of a module, which it keeps; `np` is any module.

    words, term, rank, gives_way : see `Edit`; the term is a letter, the words may depend on it
    """
    right_code, wrong_code = (ast.parse(code, mode="eval").body for code in (right, wrong))
    node_type = type(right_code), type(getattr(right_code, "op", None))

    def edits(node: ast.expr) -> tuple[Edit, ...]:
        bound = {"IT": node}
        if node_type != (type(node), type(getattr(node, "op", None))) or not _has_form(right_code, node, bound):
            return ()
        about = bound[term or "IT"]
        text = words if isinstance(words, str) else words(about)
        return (Edit(_filled(wrong_code, bound), text, about, rank=rank, gives_way=gives_way),)

    return edits


def _has_form(form: Code, part: Code, bound: dict[str, ast.expr]) -> bool:
    """Return whether a part of the code has this form; put the expressions at the form's names into `bound`."""
    if isinstance(form, ast.Name):
        if not isinstance(part, ast.expr):
            return False
        first = bound.setdefault(form.id, part)
        if form.id == "NUMBER":
            return isinstance(part, ast.Constant)
        is_any = form.id == "np" or form.id.isupper()
        return first is part or ast.dump(first) == ast.dump(part) if is_any else _name_of(part) == form.id
    if isinstance(form, ast.Constant):
        return isinstance(part, ast.Constant) and form.value == part.value
    if type(form) is not type(part):
        return False
    if isinstance(form, list):
        return len(form) == len(part) and all(_has_form(*pair, bound) for pair in zip(form, part, strict=True))
    if isinstance(form, ast.AST):
        names = (name for name in form._fields if name not in ("ctx", "keywords"))
        return all(_has_form(getattr(form, name), getattr(part, name), bound) for name in names)
    return bool(form == part)  # the name of an attribute


def _filled(form: Code, bound: Mapping[str, ast.expr]) -> Code:
    """Return the form with the bound expressions in place of its names."""
    if isinstance(form, ast.Name):
        return bound.get(form.id, form)
    if isinstance(form, list):
        return [_filled(part, bound) for part in form]
    if isinstance(form, ast.AST):
        return _with(form, **{name: _filled(part, bound) for name, part in ast.iter_fields(form)})
    return form


def mutants_of(source: str) -> Iterator[Mutant]:
    """Yield the mutants of a module's functions that have words: by the audit's operators first, then by others."""
    lines, components = source.splitlines(keepends=True), unpacked(source)
    functions = [node for node in ast.parse(source).body if isinstance(node, ast.FunctionDef)]
    public = {function.name for function in functions if function.name[0] != "_"}
    for function in functions:
        before = function.lineno - 1
        text = "\n" * before + "".join(lines[before : function.end_lineno])  # so that the lines keep their numbers
        products = _products(function)
        others = (*MORE, *_of_quantities(function, public, components))
        for node, _, edit in (*changed_expressions(function), *changed_expressions(function, others)):
            if edit.words:
                changed = replaced(text, node, ast.unparse(edit.now))
                yield Mutant(function.name, edit, edit.term or node, products.get(id(node), node), changed)
        yield from _everywhere(function)


def _products(function: ast.FunctionDef) -> dict[int, ast.expr]:
    """Return the largest product that contains each factor, by the factor's id."""
    products: dict[int, ast.expr] = {}
    for node in ast.walk(function):  # from the outside in
        if _is_operation(node, ast.Mult, ast.Div, ast.Pow):
            for factor in (node.left, node.right):
                products[id(factor)] = products.get(id(node), node)
    return products


def unpacked(source: str) -> dict[str, str]:
    """Return {part: argument} of unpacked arguments: `m1, m2 = masses`; public functions overwrite helpers."""
    functions = (node for node in ast.parse(source).body if isinstance(node, ast.FunctionDef))
    return {
        part.id: value.id
        for function in sorted(functions, key=lambda function: function.name[0] != "_")
        for target, value in assigned(function)
        if isinstance(value, ast.Name) and isinstance(target, ast.Tuple)
        for part in target.elts
        if isinstance(part, ast.Name)
    }


def assigned(function: ast.FunctionDef) -> Iterator[tuple[ast.expr, ast.expr]]:
    """Yield (target, value) of each assignment; of tuples on both sides, part by part."""
    for node in ast.walk(function):
        if isinstance(node, ast.Assign) and len(node.targets) == 1:
            targets, values = (getattr(side, "elts", [side]) for side in (node.targets[0], node.value))
            is_by_parts = len(targets) == len(values)
            yield from zip(targets, values, strict=True) if is_by_parts else [(node.targets[0], node.value)]


def _of_quantities(function: ast.FunctionDef, public: Set[str], components: Mapping[str, str]) -> tuple[Operator, ...]:
    """Return the operators that depend on the function's other names, such as one quantity for another."""
    inputs = _inputs(function)
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
    return (
        partial(_others_of_a_group, groups=groups, components=components),
        partial(_exchanged_in_a_sum, groups=groups),
        _sine_and_cosine_in_a_sum,
        partial(_as_given, raw=raw),
        partial(_ignored, computed=computed),
        partial(_multiples, computed=computed, public=public),
        partial(_other_powers, names=names_used(function) & {"mass", "curvature", *LENGTHS}),
    )


def _inputs(function: ast.FunctionDef) -> set[str]:
    return {argument.arg for argument in (*function.args.args, *function.args.kwonlyargs)}


def _as_given(node: ast.expr, raw: Mapping[str, str]) -> Iterator[Edit]:
    """Yield the argument in place of a name that is computed from it."""
    if _is_read(node) and node.id in raw:
        argument = ast.Name(raw[node.id], ast.Load())
        yield Edit(argument, f"one term uses {argument.id} as it is given", argument)


def _ignored(node: ast.expr, computed: Set[int]) -> Iterator[Edit]:
    """Yield zero in place of a product that is assigned to a name."""
    if id(node) in computed and _is_operation(node, ast.Mult):
        exact = "{term} is ignored, as if it were zero"
        # the quantity may be a missing term
        yield Edit(ast.Constant(0.0), "a quantity{} is ignored, as if it were zero", exact=exact, gives_way=3)


def _multiples(node: ast.expr, computed: Set[int], public: Set[str]) -> Iterator[Edit]:
    """Yield the result of another public function, if it is assigned to a name, doubled and halved."""
    if id(node) in computed and isinstance(node, ast.Call) and _name_of(node.func) in public:
        for number in (2, 0.5):
            words = f"the result of {ast.unparse(node.func)} is multiplied by {number}"
            yield Edit(_times(number, node), words, gives_way=3)


def _others_of_a_group(node: ast.expr, groups: Sequence[Set[str]], components: Mapping[str, str]) -> Iterator[Edit]:
    """Yield the other names of a group: C in place of A if `A, C = inertia`, or the offset in place of the radius."""
    if _is_read(node):
        for other in sorted({other for group in groups if node.id in group for other in group - {node.id}}):
            words = f"{other} is used for {node.id}" if node.id in LENGTHS else "the wrong quantity is used{}"
            if node.id in components:
                words = f"the wrong component of {components[node.id]} is used"
            yield Edit(ast.Name(other, ast.Load()), words)


def _other_powers(node: ast.expr, names: Set[str]) -> Iterator[Edit]:
    """Yield the sum with one of its two terms multiplied or divided by a mass, a curvature or a length."""
    if _is_operation(node, ast.Add, ast.Sub):
        words = {ast.Mult: "a term{{}} has a factor {} too many", ast.Div: "a term{{}} lacks a factor {}"}
        for side, name, op in product(("left", "right"), sorted(names), words):
            term = getattr(node, side)
            now = _with(node, **{side: ast.BinOp(term, op(), ast.Name(name, ast.Load()))})
            yield Edit(now, words[op].format(name), term, rank=2)


def _exchanged_in_a_sum(node: ast.expr, groups: Sequence[Set[str]]) -> Iterator[Edit]:
    """Yield p a + q b in place of p b + q a for two names of a group."""
    if _is_operation(node, ast.Add, ast.Sub):
        names = names_used(node)
        for pair in (pair for group in groups for pair in combinations(sorted(group & names), 2)):
            yield Edit(_with_exchanged(node, *pair), EXCHANGED, gives_way=2)


def _sine_and_cosine_in_a_sum(node: ast.expr) -> Iterator[Edit]:
    """Yield p cos + q sin in place of p sin + q cos."""
    if _is_operation(node, ast.Add, ast.Sub):
        calls = {_name_of(each.func) for each in ast.walk(node) if isinstance(each, ast.Call)}
        if {"sin", "cos"} <= calls:
            yield Edit(_with_exchanged(node, "sin", "cos"), SINE_AND_COSINE)


def _with_exchanged(node: ast.expr, first: str, other: str) -> ast.expr:
    """Return a copy of an expression with two variables, or functions of modules, exchanged."""
    names, changed = {first: other, other: first}, copy.deepcopy(node)
    for inner in ast.walk(changed):
        if isinstance(inner, ast.Name):
            inner.id = names.get(inner.id, inner.id)
        elif isinstance(inner, ast.Attribute):
            inner.attr = names.get(inner.attr, inner.attr)
    return changed


def _everywhere(function: ast.FunctionDef) -> Iterator[Mutant]:
    """Yield mutants with a slip in every place: each sine a cosine, each square a product; or only of one angle."""
    expressions = [node for node in ast.walk(function) if isinstance(node, ast.expr)]
    angles = {ast.dump(node.args[0]) for node in expressions if _is_call(node, ("sin", "cos"))}
    of_angles: list[Operator] = [partial(_sines_and_cosines, angle=angle) for angle in (None, *sorted(angles))]
    for operators in (*EVERYWHERE, *((operator,) for operator in of_angles)):
        if not any(any(operator(node)) for node in expressions for operator in operators):
            continue  # faster than to copy the function first
        changer = _InEveryPlace(operators)
        changed = changer.visit(function)
        if len(changer.places) > 1:
            places = ast.Tuple(changer.places)
            text = ast.unparse(ast.fix_missing_locations(changed))
            yield Mutant(function.name, changer.edits[0], places, places, text)


class _InEveryPlace(ast.NodeTransformer):
    """Applies the first operator that fits to each expression of a copy."""

    def __init__(self, operators: Sequence[Operator]) -> None:
        self.operators, self.places, self.edits = operators, list[ast.expr](), list[Edit]()

    def visit(self, node: ast.AST) -> ast.AST:
        lists = {name: [*field] for name, field in ast.iter_fields(node) if isinstance(field, list)}
        node = self.generic_visit(_with(node, **lists))
        if isinstance(node, ast.expr):
            for edit in (edit for operator in self.operators for edit in operator(node)):
                self.edits.append(edit)
                self.places.append(node)
                return edit.now
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
    function: ast.FunctionDef, chosen: tuple[Operator, ...] = ()
) -> Iterator[tuple[ast.expr, str, Edit]]:
    """Yield each expression of a body, an operator's name and its edit; leave out messages and tolerances.

    chosen : operators other than those of the audit; they have no names, and do not change constants in an index
    """
    spared, bases = set[int](), set[int]()
    for node in ast.walk(function):
        if isinstance(node, ast.Raise) or (isinstance(node, ast.keyword) and node.arg == "rtol"):
            spared |= {id(inner) for inner in ast.walk(node)}
        if isinstance(node, ast.Subscript) and chosen:
            spared |= {id(inner) for inner in ast.walk(node.slice) if isinstance(inner, ast.Constant)}
        if _is_operation(node, ast.Pow):
            bases.add(id(node.left))
    operators: dict[str, tuple[Operator, ...]] = {"": chosen}
    if not chosen:
        counterparts, copies = partial(_counterparts, bases=bases), partial(_copies, inputs=_inputs(function))
        operators = {**OPERATORS, "another function": (counterparts,), "a missing copy": (copies,)}
    for statement in function.body:
        for node in ast.walk(statement):
            if isinstance(node, ast.If) and not chosen:
                yield from ((node.test, "a branch", Edit(ast.Constant(always))) for always in (True, False))
            if isinstance(node, ast.expr) and id(node) not in spared:
                for name, group in operators.items():
                    yield from ((node, name, edit) for operator in group for edit in operator(node))


def _missing(term: ast.expr) -> str:
    """Return the words for a missing term, which name a number, or the first time."""
    text = ast.unparse(term)
    is_number = isinstance(term, ast.Constant) or text == "t[0]"
    return f"the term {text.removesuffix('.0')} is missing" if is_number else MISSING_TERM


def _exponents(node: ast.expr) -> Iterator[Edit]:
    if _is_operation(node, ast.Pow) and isinstance(node.right, ast.Constant):
        power = ast.literal_eval(node.right)
        for other in (power + 1, power - 1):
            yield Edit(_with(node, right=ast.Constant(other)), "an exponent{} is one too large or too small")


def _factors(node: ast.expr) -> Iterator[Edit]:
    """Yield the number doubled and, for a float, halved; instead, its term may count twice."""
    if number := _number(node):
        yield Edit(ast.Constant(2 * number), TWICE_OR_HALF, gives_way=2)
        if isinstance(number, float):
            yield Edit(ast.Constant(number / 2), TWICE_OR_HALF, gives_way=2)


def _counterparts(node: ast.expr, bases: Set[int] = frozenset(), words: str = OTHER_FUNCTION) -> Iterator[Edit]:
    """Yield a call of the counterpart, such as cos in place of sin.

    bases : ids of the expressions to which the function applies an exponent
    """
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr in COUNTERPARTS:
        numbers = [part.value for part in ast.walk(node) if isinstance(part, ast.Constant)]
        if id(node) in bases and numbers in ([2], [0.5]):
            words = "a cosine{} has the wrong sign"  # 2 sin(x/2)^2 is 1 - cos x
        yield Edit(_with(node, func=_with(node.func, attr=COUNTERPARTS[node.func.attr])), words)


def _sines_and_cosines(
    node: ast.expr, names: Sequence[str] = ("sin", "cos"), angle: str | None = None, words: str = SINE_AND_COSINE
) -> Iterator[Edit]:
    """Yield cosine in place of sine, or sine in place of cosine, of one angle or, for None, of any."""
    if _is_call(node, names) and angle in (None, ast.dump(node.args[0])):
        yield from _counterparts(node, words=words)


def _copies(node: ast.expr, inputs: set[str]) -> Iterator[Edit]:
    """Yield the input in place of its copy."""
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
        if node.func.attr == "array" and len(node.args) == 1 and getattr(node.args[0], "id", None) in inputs:
            yield Edit(node.args[0])
        if node.func.attr == "copy" and not node.args:
            yield Edit(node.func.value)


def _arguments(node: ast.expr) -> Iterator[Edit]:
    """Yield the call, list or tuple with two neighbouring arguments or elements exchanged."""
    field, parts = "elts", _elements(node)
    if isinstance(node, ast.Call) and _name_of(node.func) not in SYMMETRIC:
        field, parts = "args", node.args
    for i, (first, second) in enumerate(pairwise(parts)):
        if not _equal(first, second):
            now = _with(node, **{field: [*parts[:i], second, first, *parts[i + 2 :]]})
            yield Edit(now, EXCHANGED, gives_way=2)


def _equal(first: ast.expr, other: ast.expr) -> bool:
    return isinstance(first, ast.Constant) and isinstance(other, ast.Constant) and first.value == other.value


def _indices(node: ast.expr) -> Iterator[Edit]:
    if isinstance(node, ast.Subscript) and isinstance(node.slice, ast.Constant) and isinstance(node.ctx, ast.Load):
        index = node.slice.value
        if isinstance(index, int):
            yield Edit(_with(node, slice=ast.Constant(index - 1 if index else 1)), COMPONENT)


def _conditions(node: ast.expr) -> Iterator[Edit]:
    """Yield <= in place of <, and or in place of and."""
    if isinstance(node, ast.Compare) and len(node.ops) == 1 and type(node.ops[0]) in OPPOSITES:
        yield Edit(_with(node, ops=[OPPOSITES[type(node.ops[0])]()]))
    if isinstance(node, ast.BoolOp):
        yield Edit(_with(node, op=OPPOSITES[type(node.op)]()))


def _missing_factors(node: ast.expr) -> Iterator[Edit]:
    if _is_operation(node, ast.Mult, ast.MatMult, ast.Div):
        divides = isinstance(node.op, ast.Div)
        exact = f"the {'division by' if divides else 'factor'} {{term}} is missing{{beside}}"
        for now, factor in ((node.left, node.right), (node.right, node.left))[: 1 if divides else 2]:
            if isinstance(factor, ast.Constant) and factor.value in (2, 0.5):
                yield Edit(now, TWICE_OR_HALF, factor, exact, gives_way=2)
            else:
                yield Edit(now, MISSING_FACTOR, factor, exact)


def _factors_of_one_term(node: ast.expr) -> Iterator[Edit]:
    """Yield f A + B and A + f B in place of a product f (A + B)."""
    total = _sum_in(node) if _is_operation(node, ast.Mult, ast.Div) else None
    if total:
        left, right = _put_in(node, total, total.left), _put_in(node, total, total.right)
        words = "the factors of a sum{} multiply only one of its terms, as without parentheses"
        for now in (_with(total, left=left), _with(total, right=right)):
            yield Edit(now, words, total, rank=2)


def _sum_in(node: ast.expr) -> ast.BinOp | None:
    """Return the first sum or difference of two terms among the factors of a product, else None."""
    if _is_operation(node, ast.Mult, ast.Div):
        return _sum_in(node.left) or (_sum_in(node.right) if isinstance(node.op, ast.Mult) else None)
    return node if _is_operation(node, ast.Add, ast.Sub) else None


def _put_in(node: ast.expr, part: ast.expr, other: ast.expr) -> ast.expr:
    """Return a product with another expression in place of one of its factors."""
    if node is part or not isinstance(node, ast.BinOp):
        return other if node is part else node
    return _with(node, left=_put_in(node.left, part, other), right=_put_in(node.right, part, other))


def _components(node: ast.expr) -> Iterator[Edit]:
    """Yield the list or tuple with one computed element of the opposite sign, or replaced by zero."""
    elements = _elements(node)
    for k, element in enumerate(elements):
        if isinstance(element, ast.BinOp | ast.Call):
            reversed_ = ast.UnaryOp(ast.USub(), element)
            yield Edit(_with(node, elts=[*elements[:k], reversed_, *elements[k + 1 :]]), SIGN, element)
        if not isinstance(element, ast.Constant | ast.Name | ast.Starred | ast.Tuple | ast.List):
            zero = _times(0, element)
            yield Edit(_with(node, elts=[*elements[:k], zero, *elements[k + 1 :]]), MISSING_TERM, element)


def _numbers(node: ast.expr) -> Iterator[Edit]:
    """Yield the number times ratios of numbers in formulas, such as 4: 1/3 in place of 1/12."""
    if number := _number(node):
        for ratio in RATIOS:
            yield Edit(ast.Constant(number * ratio), "a number{} is not the right one", rank=3)


def _products_for_squares(node: ast.expr) -> Iterator[Edit]:
    """Yield om1 * om2 in place of om1**2 and om1 * om1."""
    if not isinstance(node, ast.BinOp):
        return
    last = node.left.right if isinstance(node.left, ast.BinOp) else node.left
    if isinstance(node.op, ast.Pow) and _equal(node.right, ast.Constant(2)):
        changes = [ast.BinOp(node.left, ast.Mult(), other) for other in _other(node.left)]
    elif isinstance(node.op, ast.Mult) and ast.dump(last) == ast.dump(node.right):
        changes = [_with(node, right=other) for other in _other(node.right)]
    else:
        return
    yield from (Edit(now, "a square{} is a product of two quantities") for now in changes)


def _other(node: ast.expr) -> Iterator[ast.expr]:
    """Yield the second of two quantities in place of the first, by the digit in its name, or the reverse."""
    if isinstance(node, ast.Name) and node.id[-1:] in "12":
        yield ast.Name(node.id[:-1] + "21"[int(node.id[-1]) - 1], ast.Load())


def _divisors(node: ast.expr) -> Iterator[Edit]:
    """Yield a / sqrt(b) and a / b**2 in place of a / b; `_exponents` changes powers."""
    if _is_operation(node, ast.Div):
        divisor = node.right
        is_number = isinstance(divisor, ast.Constant) or _is_operation(divisor, ast.Pow)
        if not is_number and _name_of(getattr(divisor, "func", divisor)) != "sqrt":
            for power, what in ((0.5, "its square root"), (2, "squared")):
                now = _with(node, right=ast.BinOp(divisor, ast.Pow(), ast.Constant(power)))
                yield Edit(now, f"a divisor{{}} is {what}", divisor)


def _other_sines(factor: float, words: str) -> tuple[Operator, ...]:
    return tuple(rule(f"{name}(A)", f"{name}({factor} * A)", words) for name in ("sin", "cos", "tan"))


def _other_angles(factor: float, words: str) -> tuple[Operator, ...]:
    """Return the operators that yield a multiple or a fraction of pi times the factor, such as pi / 4 or -pi / 2."""
    forms = product("*/", ("pi {} NUMBER", "NUMBER {} pi"))
    return tuple(rule(form.format(op), f"{factor} * IT", words) for op, form in forms)


LINEAR = tuple(  # a cosine may be a missing factor
    rule(f"{name}(A)", linear, "a sine or cosine{} is linearised, as for small angles", gives_way=2)
    for name, linear in (("sin", "A"), ("cos", "1.0"), ("tan", "A"))
)
DEGREES = 180 / math.pi, "an angle is in degrees; it should be in radians"
IN_DEGREES = (*_other_angles(*DEGREES), *_other_sines(*DEGREES))
IN_RADIANS = _other_sines(math.pi / 180, "an angle in radians is read as degrees")
LENGTH = "a length{} is the sum of the components, not the root of the sum of their squares"
OPERATORS: dict[str, tuple[Operator, ...]] = {  # of the audit, with two more in `changed_expressions`
    "a sign": (rule("-A", "A", SIGN), rule("not A", "A", SIGN)),
    "a term or product": (
        rule("A + B", "A - B", SIGN, "B"),
        rule("A + B", "A", _missing, "B"),
        rule("A + B", "B", _missing, "A"),
        rule("A - B", "A + B", SIGN, "B"),
        rule("A - B", "A", _missing, "B"),
        rule("A - B", "B"),  # the term has another sign, too
        *(rule(f"A {sign} B", f"A {sign} 2 * B", "a term{} counts twice", "B") for sign in "+-"),
        rule("A * B", "A / B", "a factor{} divides where it should not", "B"),
        rule("A / B", "A * B", "a factor{} multiplies where it should not", "B"),
        *(rule("A @ B", wrong, TRANSPOSED) for wrong in ("B @ A", "A.T @ B")),
    ),
    "an exponent": (_exponents,),
    "a factor": (_factors,),
    "another function": (_counterparts,),
    "swapped arguments": (_arguments,),
    "an index": (_indices,),
    "a transpose": (rule("A.T", "A", TRANSPOSED),),
    "a condition": (_conditions, rule("A if C else B", "A"), rule("A if C else B", "B")),
}
MORE: tuple[Operator, ...] = (  # of diagnosis alone
    _missing_factors,
    _factors_of_one_term,
    # others name the missing factor of the term, or the number
    *(rule(f"A {sign} B", f"A {sign} 0.5 * B", "a term{} counts half", "B", gives_way=1) for sign in "+-"),
    *(rule(f"A {sign} B", f"0.5 * A {sign} B", "a term{} counts half", "A", gives_way=1) for sign in "+-"),
    *(rule(f"A[{index}]", "A[2]", COMPONENT) for index in (0, 1)),  # `_indices` yields the others
    *(rule(f"A {sign} B", f"-A {sign} B", SIGN, "A") for sign in "+-"),
    _components,
    _numbers,
    *LINEAR,
    _products_for_squares,
    rule("hypot(A, B)", "(A * A + B) ** 0.5", "a quantity{} is not squared"),
    rule("A**2 + B**2", "IT ** 0.5", "a quantity{} is not squared"),
    rule("A**2 + B**2", "(A + B) ** 2", "a sum{} is squared as a whole; square each of its terms"),
    rule("1 + B**2", "(1 + B) ** 2", "a sum{} is squared as a whole; square each of its terms"),
    *(rule(f"{name}(A)", "abs(IT)", "a sine or cosine{} has lost its sign") for name in ("sin", "cos")),
    rule("A - B", "-B", MISSING_TERM, "A"),
    *(rule(f"np.{name}(A)", "np.tan(A)", OTHER_FUNCTION) for name in ("sin", "cos")),
    rule("sqrt(A)", "A", "a square root{} is missing"),
    _divisors,
    rule("sqrt(A)", f"IT / {2 * math.pi}", "a square root{} is divided by 2 pi"),
    *(rule(norm, "sum(abs(A))", LENGTH) for norm in ("sqrt(A @ A)", "hypot(*A)", "norm(A)")),
    *IN_DEGREES,
    *IN_RADIANS,
    *_other_angles(-1.0, "an angle has the opposite sign"),
    *(rule(repr(z), repr(x), f"the axis is {x!r} where it should be {z!r}") for z, x in permutations("xyz", 2)),
    *(
        rule(f"{name}(A, B)", f"{name}({args})", TWICE_OR_HALF, gives_way=2)
        for name, args in product(("arctan2", "atan2"), ("2 * A, B", "A, 2 * B"))
    ),
    rule("A / 3", "1.75 * IT", "m l^2/4 is added to m l^2/3{}; a third is a bar's inertia about its end already"),
    rule("A / 3", "0.25 * IT", "m l^2/12 is used for m l^2/3{}; a third is a bar's inertia about its end"),
    rule(
        "A / 3",
        "0.75 * IT",
        "m l^2/4 is used for m l^2/3{}; the bar's inertia m l^2/12 about its mass centre is missing",
    ),
)
EVERYWHERE: tuple[tuple[Operator, ...], ...] = (
    *((partial(_sines_and_cosines, names=(name,), words=OTHER_FUNCTION),) for name in ("sin", "cos")),
    LINEAR,
    (_products_for_squares,),
    IN_DEGREES,
    IN_RADIANS,
    _other_angles(0.5, "an angle is half the right one"),
    # few mutants, whose numbers hardly any other has
    (rule("A / 2", "A", EVERY_HALF, rank=0), rule("0.5", "1.0", EVERY_HALF, rank=0)),
)


def _is_operation(node: ast.AST, *operators: type[ast.operator]) -> TypeGuard[ast.BinOp]:
    return isinstance(node, ast.BinOp) and isinstance(node.op, operators)


def _is_call(node: ast.expr, names: Container[str]) -> TypeGuard[ast.Call]:
    """Return whether an expression is a call of one of these functions with one argument."""
    return isinstance(node, ast.Call) and _name_of(node.func) in names and len(node.args) == 1


def _number(node: ast.expr) -> int | float:
    """Return the number that an expression is; 0 for others."""
    value = node.value if isinstance(node, ast.Constant) else 0
    return value if isinstance(value, int | float) and not isinstance(value, bool) else 0


def _elements(node: ast.expr) -> list[ast.expr]:
    """Return the elements of a list or a tuple; in A[:, 1] there is none."""
    elements = node.elts if isinstance(node, ast.List | ast.Tuple) and isinstance(node.ctx, ast.Load) else []
    return [] if any(isinstance(element, ast.Slice) for element in elements) else elements


def _is_read(node: ast.expr) -> TypeGuard[ast.Name]:
    """Return whether an expression is the value of a name, to which nothing is assigned there."""
    return isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load)


def _with(node: Node, **fields: object) -> Node:
    """Return a copy of the node with these fields changed."""
    return type(node)(**{**vars(node), **fields})  # copy.copy takes five times as long


def _times(number: float, node: ast.expr) -> ast.expr:
    return ast.BinOp(ast.Constant(number), ast.Mult(), node)


def _name_of(function: ast.expr) -> str:
    return getattr(function, "attr", getattr(function, "id", ""))
