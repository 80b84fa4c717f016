"""Mistakes that nobody has written down: a sign, a factor, a swapped pair, degrees, a missing term, found by trying.

Where no known mistake gives the student's numbers, two families of variants are tried on the same inputs. The first
changes the arguments or the result of the right function; the second makes one slip in the solution's own code. A
variant is named if it alone explains every call of the check, of which at least two are wrong.
"""

import ast
import copy
import functools
import inspect
import re
import warnings
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from types import CodeType, ModuleType
from typing import Any

import numpy as np

from tam570_grader.checks.case import Case
from tam570_grader.checks.effort import Exhausted, compile_counted, count, limited
from tam570_grader.diagnosis.cause import Answer, Called, Cause
from tam570_grader.diagnosis.compared_call import Judged, judged, telling
from tam570_grader.diagnosis.mistakes import WITHIN, answer, computed, parts, right_answer, solution_with
from tam570_grader.diagnosis.mutants import Slip, reached, slips
from tam570_grader.diagnosis.transforms import (
    WrongArgument,
    other_arguments,
    other_forms,
    other_products,
    other_results,
)

__all__ = ["general", "wrong_arguments"]

FEWEST = 2  # wrong answers: one may agree by chance
MOST = 1_000_000  # steps of all variants, about a second; what is named takes a third of them
OF_ONE = 100_000  # steps of one variant in one call: a slip may go round for ever
ELEMENTS = 1000  # of a result, that are compared in a step
Variant = Callable[[Judged], Any]


def general(solution: str, calls: Sequence[Called]) -> Cause | None:
    """The one variant of the right answers that has the student's numbers in every call, or None.

    Formulas are left out: to evaluate one takes long.
    """
    try:
        with limited(MOST):
            return _general(solution, calls)
    except Exhausted:
        return None


def _general(solution: str, calls: Sequence[Called]) -> Cause | None:
    if any(call.result is None or _symbolic(call) for call in calls):
        return None
    expected = [right_answer(solution, call) for call in calls]
    known = [judged(call, right) for call, right in zip(calls, expected, strict=True)]
    wrong = [call for call in known if not call.fits(call.right)]
    names = {call.name for call in wrong}
    if len(names) != 1 or any(right is None for right in expected):
        return None
    (name,) = names
    own = [call for call in known if call.name == name]
    if not any(np.any(part) for call in own for part in parts(call.result)):
        return Cause(name, f"The result of {name} is zero", "transform")
    if telling(wrong) < FEWEST:
        return None
    module = ModuleType("_varied")  # its own, to make slips in
    exec(_code(solution), vars(module))
    right = getattr(module, name)
    known_for = {str(call.case.kwargs) for call in wrong}
    results = other_results(name, wrong[0], vary=len(known_for) >= FEWEST or not wrong[0].case.kwargs)
    if first := _first(results, own):
        return Cause(name, first[0], "transform", _with_variant(solution, name, first[1]), tuple(calls))
    for family in (other_arguments(name, right, own[0]), other_products(name, right, own[0])):
        told = [(says, variant) for says, variant in family if _explains(variant, own)]
        if len(told) == 1:
            ((says, variant),) = told
            return Cause(name, says, "transform", _with_variant(solution, name, variant), tuple(calls))
    if found := _for_one_word(solution, name, right, known, calls):
        return found
    if slip := _slip(solution, module, name, known):
        says, texts = slip
        return Cause(name, says, "mutant", tuple(partial(answer, solution, text) for text in texts), tuple(calls))
    if first := _first(other_forms(name, right, own[0]), own):
        return Cause(name, first[0], "transform", _with_variant(solution, name, first[1]), tuple(calls))
    place = _single_entry(name, own)
    return Cause(name, place, "place") if place else None


def _first(family: Iterator[tuple[str, Variant]], calls: Sequence[Judged]) -> tuple[str, Variant] | None:
    return next(((says, variant) for says, variant in family if _explains(variant, calls)), None)


def _for_one_word(
    solution: str, name: str, right: Any, calls: Sequence[Judged], whole: Sequence[Called]
) -> Cause | None:
    """The one wrong argument, where a function is wrong for one value alone of an argument that is a word."""
    wrong, keys = [call for call in calls if not call.fits(call.right)], [*inspect.signature(right).parameters]
    for place, word in enumerate(wrong[0].case.args):
        if isinstance(word, str) and all(_word(call, place) == word for call in wrong):
            family = [*other_arguments(name, right, wrong[0])]
            told = [(says, variant) for says, variant in family if _explains(_Where(place, word, variant), calls)]
            if len(told) == 1:
                ((says, variant),) = told
                answers = _with_variant(solution, name, _Where(place, word, variant))
                return Cause(name, f"{says} where {keys[place]} is {word!r}", "transform", answers, tuple(whole))
    return None


def _word(call: Judged, place: int) -> Any:
    return call.case.args[place] if place < len(call.case.args) else None


@dataclass(frozen=True)
class _Where:
    """A variant for one word, the right answer for all others."""

    place: int
    word: str
    variant: Variant

    def __call__(self, call: Judged) -> Any:
        return self.variant(call) if _word(call, self.place) == self.word else call.right


def wrong_arguments(solution: str, calls: Sequence[Called]) -> Iterator[Cause]:
    """Each wrong argument that explains all calls of a function: there may be several, of which one was made before."""
    if not calls or any(call.result is None or _symbolic(call) for call in calls):
        return
    name, right = calls[0].name, getattr(solution_with(solution, ""), calls[0].name)
    known = [judged(call, right_answer(solution, call)) for call in calls]
    if any(call.name != name or call.right is None for call in known):
        return
    for says, variant in other_arguments(name, right, known[0]):
        if isinstance(variant, WrongArgument) and _explains(variant, known):
            yield Cause(name, says, "transform", _with_variant(solution, name, variant), tuple(calls))


def _with_variant(solution: str, name: str, variant: Variant) -> tuple[Answer, ...]:
    """What the solution answers with a variant of one of its functions, or with its wrong argument in all of them."""
    if isinstance(variant, WrongArgument):
        return partial(_everywhere, solution, variant), _InPlace(solution, name, variant)
    return (_InPlace(solution, name, variant),)


def _everywhere(solution: str, wrong: WrongArgument, call: Called) -> Any:
    function = getattr(solution_with(solution, ""), call.name)
    case = Case(**wrong.arguments(function, call.case))
    return answer(solution, "", Judged(call.name, case, None, None))


@dataclass(frozen=True)
class _InPlace:
    """What the solution answers with a variant in the place of one of its functions, whatever its others make of it."""

    solution: str
    name: str
    variant: Variant

    def __call__(self, call: Called) -> Any:
        try:
            return computed(self._module, call)
        except (LookupError, TypeError, AttributeError):
            return None

    @functools.cached_property
    def _module(self) -> ModuleType:
        module = solution_with.__wrapped__(self.solution, "")  # its own
        right = getattr(module, self.name)

        def varied(*args: Any, **kwargs: Any) -> Any:
            return self.variant(Judged(self.name, Case(*args, **kwargs), None, right(*args, **kwargs)))

        setattr(module, self.name, varied)
        return module


def _symbolic(call: Called) -> bool:
    args = call.case.args
    return bool(args) and isinstance(args[0], list) and bool(args[0]) and isinstance(args[0][0], dict)


def _explains(variant: Variant, calls: Sequence[Judged]) -> bool:
    return all(call.fits(_quietly(variant, call)) for call in calls)


def _quietly(variant: Variant, call: Judged) -> Any:
    """The answer of a variant; None where it has none, whatever is in its way."""
    count(1 + sum(map(np.size, parts(call.right))) // ELEMENTS)
    try:
        with np.errstate(all="ignore"), warnings.catch_warnings(action="ignore"), limited(OF_ONE):
            return variant(call)
    except (Exhausted, ArithmeticError, LookupError, TypeError, ValueError, AttributeError, NameError):
        return None


def _slip(solution: str, module: ModuleType, name: str, calls: Sequence[Judged]) -> tuple[str, list[str]] | None:
    """What to say of the slips that explain all calls, if they are of one kind, and the functions with them."""
    public = set(inspect.signature(getattr(module, name)).parameters)
    found: dict[str, dict[str, str]] = {}
    factors = set[str]()
    numbers_last = sorted(_slips(solution), key=lambda slip: slip[1] == KINDS["a number"])
    for helper, kind, terms, factor, text in numbers_last:
        if found and kind == KINDS["a number"]:
            break
        term = ", ".join(sorted(terms & public))
        if helper in reached(solution)[name] and term not in found.get(kind, ()):
            with _slipped(module, helper, _code(text)):
                if _explains(partial(_called, module), calls):
                    found.setdefault(kind, {})[term] = text
                    factors.add(factor)
    if len(found) > 1:
        found.pop(KINDS["a factor"], None)  # a number is in the term that counts twice
    if len(found) != 1:
        return None
    ((kind, told),) = found.items()
    if len(factors) == 1 and (factor := factors.pop()):
        return f"In {name}, the factor {factor}", list(told.values())
    (term,) = told if len(told) == 1 else ("",)
    return f"In {name}, {kind.format(f' with {term}' if term else '')}", list(told.values())


def _called(module: ModuleType, call: Judged) -> Any:
    return getattr(module, call.name)(*call.case.args, **call.case.kwargs)


def _single_entry(name: str, calls: Sequence[Judged]) -> str | None:
    """Where a matrix is wrong, if it is in one place."""
    forms = {tuple(map(np.shape, parts(one))) for call in calls for one in (call.result, call.right)}
    if len(forms) > 1 or [len(shape) for shape in forms.pop()] != [2]:
        return None
    off = [np.abs(call.result - call.right) > WITHIN * np.abs(call.right).max() for call in calls]
    places = np.argwhere(np.any(off, axis=0))
    if len(places) != 1:
        return None
    row, column = places[0] + 1
    return f"The result of {name} is wrong in row {row}, column {column} alone"


@contextmanager
def _slipped(module: ModuleType, helper: str, code: CodeType) -> Iterator[None]:
    right = getattr(module, helper)
    exec(code, vars(module))
    try:
        yield
    finally:
        setattr(module, helper, right)


@functools.cache
def _slips(solution: str) -> list[tuple[str, str, set[str], str, str]]:
    """Of each slip that has words: the function, the words, the names in the term, a missing factor, its text."""
    parameters, locals_of = _unpacked(solution), _locals(solution)
    return [
        (
            function,
            words,
            {parameters.get(name, name) for name in _names(slip.product if isinstance(term, ast.Constant) else term)},
            _missing(term, slip.product, locals_of[function]) if slip.operator == "a missing factor" else "",
            slip.text,
        )
        for function, known in slips(solution).items()
        for slip in known
        for words, term in _words(slip)
    ]


def _unpacked(solution: str) -> dict[str, str]:
    """What the parts of an argument are called: `m1, m2 = masses`."""
    return {
        part.id: node.value.id
        for node in ast.walk(ast.parse(solution))
        if isinstance(node, ast.Assign) and isinstance(node.value, ast.Name) and isinstance(node.targets[0], ast.Tuple)
        for part in node.targets[0].elts
        if isinstance(part, ast.Name)
    }


def _locals(solution: str) -> dict[str, dict[str, ast.expr]]:
    """For each function the quantities that it computes, each from an expression, beside its parameters."""
    found: dict[str, dict[str, ast.expr]] = {}
    for function in (node for node in ast.parse(solution).body if isinstance(node, ast.FunctionDef)):
        arguments = function.args
        own = found[function.name] = {
            one.arg: ast.Name(one.arg) for one in (*arguments.args, *arguments.kwonlyargs)
        }  # those stand for themselves
        for node in ast.walk(function):
            if isinstance(node, ast.Assign) and len(node.targets) == 1:
                targets, values = (getattr(one, "elts", [one]) for one in (node.targets[0], node.value))
                whole = [ast.Name(target.id) for target in targets if isinstance(target, ast.Name)]
                pairs = zip(targets, values if len(values) == len(targets) else whole, strict=False)
                own |= {target.id: value for target, value in pairs if isinstance(target, ast.Name)}
    return found


def _missing(factor: ast.expr, product: ast.expr, known: Mapping[str, ast.expr]) -> str:
    """What is missing, and beside which parameters; "" if it has no short name."""
    words, names = _in_parameters(factor, known), _names(product) - _names(factor)
    beside = ", ".join(sorted(name for name in names if ast.unparse(known.get(name, product)) == name))
    return words and f"{words} is missing{beside and f' beside {beside}'}"


def _in_parameters(term: ast.expr, known: Mapping[str, ast.expr]) -> str:
    """A factor as a student may have written it; "" if that is long, or not of parameters alone."""

    class InParameters(ast.NodeTransformer):
        def visit_Name(self, node: ast.Name) -> ast.expr:
            value = known.get(node.id, node)
            return value if isinstance(value, ast.Name) or isinstance(node.ctx, ast.Store) else self.visit(value)

    try:
        text = ast.unparse(InParameters().visit(copy.deepcopy(term)))
    except RecursionError:  # it is computed from itself
        return ""
    words = re.sub(r"\b(math|np|numpy)\.", "", text)
    return words if len(words) <= LONGEST and set(re.findall(r"[A-Za-z_]\w*", words)) <= known.keys() | WORDS else ""


LONGEST, WORDS = 24, {"sin", "cos", "tan", "sqrt", "exp", "pi"}


def _names(term: ast.expr) -> set[str]:
    return {node.id for node in ast.walk(term) if isinstance(node, ast.Name)}


@functools.cache
def _code(text: str) -> CodeType:
    return compile_counted(text, "<slip>", in_python=True)


def _words(slip: Slip) -> Iterator[tuple[str, ast.expr]]:
    """What a student reads of a slip, and the term that it is about."""
    was, now = slip.was, slip.now
    if slip.operator in ("linearised", "a product for a square", "a missing square"):
        yield KINDS[slip.operator], was
    elif slip.operator == "a missing factor" and isinstance(was, ast.BinOp):
        dropped = was.right if now is was.left else was.left
        yield KINDS["a factor"] if _is_two(dropped) else "a factor{} is missing", dropped
    elif slip.operator == "a first sign" and isinstance(was, ast.BinOp):
        yield KINDS["a sign"], was.left
    elif isinstance(was, ast.BinOp) and isinstance(was.op, ast.Add | ast.Sub):
        if now in (was.left, was.right):
            yield "a term{} is missing", was.left if now is was.right else was.right
        elif isinstance(now, ast.BinOp) and now.right is was.right:
            yield "the sign of a term{} is reversed", was.right
        else:
            yield "a term{} counts twice", was.right
    elif isinstance(was, ast.BinOp) and isinstance(was.op, ast.Mult | ast.Div) and slip.operator != "an exponent":
        multiplied = isinstance(was.op, ast.Mult)
        yield f"a factor{{}} {'divides' if multiplied else 'multiplies'} where it should not", was.right
    elif isinstance(was, ast.BinOp) and isinstance(was.op, ast.MatMult):
        yield KINDS["a transpose"], was
    elif isinstance(was, ast.Call) and slip.operator == "another function" and any(map(_is_half, was.args)):
        yield "a cosine{} has the wrong sign", was  # 2 sin(x/2)^2 is 1 - cos x
    elif slip.operator in KINDS:
        yield KINDS[slip.operator], was


def _is_two(node: ast.expr) -> bool:
    return isinstance(node, ast.Constant) and node.value in (2, 0.5)


def _is_half(node: ast.expr) -> bool:
    numbers = [one.value for one in ast.walk(node) if isinstance(one, ast.Constant)]
    return isinstance(node, ast.BinOp) and numbers in ([2], [0.5])


KINDS = {
    "a sign": "the sign of a term{} is reversed",
    "an exponent": "an exponent{} is one too large or too small",
    "a factor": "a number{} is twice or half the right one",
    "a number": "a number{} is not the right one",
    "another function": "the wrong function is used{}, such as sine for cosine",
    "swapped arguments": "two quantities{} are exchanged",
    "an index": "the wrong component is used{}",
    "linearised": "a sine or cosine{} is linearised, as for small angles",
    "a product for a square": "a square{} is a product of two quantities",
    "a missing square": "a quantity{} is not squared",
    "a transpose": "matrices{} are multiplied in the wrong order, or one is transposed",
}
