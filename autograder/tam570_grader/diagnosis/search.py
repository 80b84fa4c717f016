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
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from types import CodeType, ModuleType

import numpy as np

from tam570.checking.transforms import (
    AXES,
    SPACE,
    WrongArgument,
    other_arguments,
    other_factors,
    other_forms,
    other_products,
    other_results,
    other_words,
    parts,
)
from tam570.values import Function, Numbers
from tam570_grader.checks.case import Call, Case
from tam570_grader.checks.effort import Exhausted, compile_counted, count, limited
from tam570_grader.diagnosis.cause import Answer, Cause
from tam570_grader.diagnosis.compared_call import ComparedCall, compared_call, count_informative
from tam570_grader.diagnosis.mistakes import WITHIN, answer, computed, right_answer, solution_with
from tam570_grader.diagnosis.mutants import Mutant, mutants_of, names_used, reached

FEWEST = 2  # wrong answers: one may agree by chance
MOST = 1_000_000  # steps of all variants, about a second; what is named takes a third of them
OF_ONE = 100_000  # steps of one variant in one call: a mutant may go round for ever
REVERSED = "has the opposite sign"
ELEMENTS = 1000  # of a result, that are compared in a step
Transform = Callable[[ComparedCall], Numbers]


def general(solution: str, calls: Sequence[Call]) -> Cause | None:
    """Return the one variant of the right answers that has the student's numbers in every call, or None.

    Of a formula the results alone are varied: to evaluate another takes long.
    """
    try:
        with limited(MOST):
            return _general(solution, calls)
    except Exhausted:
        return None


def _compared(solution: str, calls: Sequence[Call]) -> list[ComparedCall]:
    """Return the calls beside the right answers; nothing where one failed, or has no right answer."""
    if any(call.result is None for call in calls):
        return []
    expected = [right_answer(solution, call) for call in calls]
    compared = [compared_call(call, value) for call, value in zip(calls, expected, strict=True)]
    return [] if any(value is None for value in expected) else compared


def _general(solution: str, calls: Sequence[Call]) -> Cause | None:
    compared = _compared(solution, calls)
    wrong = [call for call in compared if not call.fits(call.expected)]
    names = {call.name for call in wrong}
    if len(names) != 1:
        return None
    (name,) = names
    its_calls = [call for call in compared if call.name == name]
    if not any(np.any(part) for call in its_calls for part in parts(call.result)):
        return Cause(name, f"Your result of {name} is zero", "transform")
    if count_informative(wrong) < FEWEST:
        return None
    known_for = {str(call.case.kwargs) for call in wrong}
    module = ModuleType("_varied")  # its own, to put mutants in
    exec(_code(solution), vars(module))
    vary = len(known_for) >= FEWEST or not wrong[0].case.kwargs
    results = other_results(name, getattr(module, name), wrong[0], vary=vary)
    if first := next(_explaining(results, its_calls), None):
        words, transform = first
        return Cause(name, words, "transform", _with_variant(solution, name, transform), tuple(calls))
    is_formula = any(call.case.points for call in its_calls)
    return None if is_formula else _inside(solution, module, name, calls, compared)


def _inside(
    solution: str, module: ModuleType, name: str, calls: Sequence[Call], compared: Sequence[ComparedCall]
) -> Cause | None:
    """Return the one variant of the arguments or of the solution's code, or the one place where the result is wrong."""
    reference = getattr(module, name)
    its_calls = [call for call in compared if call.name == name]

    def transformed(words: str, transform: Transform) -> Cause:
        return Cause(name, words, "transform", _with_variant(solution, name, transform), tuple(calls))

    families = (
        other_arguments(name, reference, its_calls[0]),
        other_factors(name, reference, its_calls[0]),
        other_products(name, reference, its_calls[0]),
        other_words(name, reference, its_calls),
    )
    for family in families:
        if len(explaining := [*_explaining(family, its_calls)]) == 1:
            return transformed(*explaining[0])
    if one_word := _for_one_word(name, reference, compared):
        return transformed(*one_word)
    if mutant := _mutant(solution, module, name, compared):
        words, texts = mutant
        return Cause(name, words, "mutant", tuple(partial(answer, solution, text) for text in texts), tuple(calls))
    if either := _either_reversed(name, reference, its_calls):
        return transformed(*either)
    if first := next(_explaining(other_forms(name, reference, its_calls[0]), its_calls), None):
        return transformed(*first)
    where = _single_entry(name, its_calls)
    return Cause(name, where, "place") if where else None


def _either_reversed(name: str, reference: Function, calls: Sequence[ComparedCall]) -> tuple[str, Transform] | None:
    """Return the argument of the wrong sign, where that of several gives the same numbers; it names them all."""
    explaining = [*_explaining(other_arguments(name, reference, calls[0]), calls)]
    if not explaining or not all(words.endswith(REVERSED) for words, _ in explaining):
        return None
    (words, transform), *others = explaining
    return ", or ".join([words, *(other.removeprefix(f"In {name}, ") for other, _ in others)]), transform


def _explaining(
    family: Iterable[tuple[str, Transform]], calls: Sequence[ComparedCall]
) -> Iterator[tuple[str, Transform]]:
    """Yield those of a family that explain all calls."""
    return ((words, transform) for words, transform in family if _explains(transform, calls))


def _for_one_word(name: str, reference: Function, calls: Sequence[ComparedCall]) -> tuple[str, Transform] | None:
    """Return the one wrong argument, where a function is wrong for one value alone of an argument that is a word."""
    wrong, keys = [call for call in calls if not call.fits(call.expected)], [*inspect.signature(reference).parameters]
    for index, word in enumerate(wrong[0].case.args):
        if isinstance(word, str) and all(_word(call, index) == word for call in wrong):
            family = other_arguments(name, reference, wrong[0])
            explaining = [*_explaining(((words, _Where(index, word, transform)) for words, transform in family), calls)]
            if len(explaining) == 1:
                ((words, transform),) = explaining
                return f"{words} where {keys[index]} is {word!r}", transform
    return None


def _word(call: ComparedCall, index: int) -> Numbers:
    return call.case.args[index] if index < len(call.case.args) else None


@dataclass(frozen=True)
class _Where:
    """A variant for one word, the right answer for all others."""

    index: int
    word: str
    transform: Transform

    def __call__(self, call: ComparedCall) -> Numbers:
        return self.transform(call) if _word(call, self.index) == self.word else call.expected


def wrong_arguments(solution: str, calls: Sequence[Call]) -> Iterator[Cause]:
    """Yield each wrong argument that explains all calls of a function.

    There may be several, of which one was made before.
    """
    compared = _compared(solution, calls)
    if len({call.name for call in compared}) != 1:
        return
    name = compared[0].name
    reference = getattr(solution_with(solution, ""), name)
    for words, transform in (*other_arguments(name, reference, compared[0]), *other_words(name, reference, compared)):
        if isinstance(transform, WrongArgument) and _explains(transform, compared):
            yield Cause(name, words, "transform", _with_variant(solution, name, transform), tuple(calls))


def _with_variant(solution: str, name: str, transform: Transform) -> tuple[Answer, ...]:
    """Compute the solution with a variant of one of its functions, or with a wrong argument in all of them."""
    if isinstance(transform, WrongArgument):
        return partial(_everywhere, solution, transform), _InPlace(solution, name, transform)
    return (_InPlace(solution, name, transform),)


def _everywhere(solution: str, wrong: WrongArgument, call: Call) -> Numbers:
    function = getattr(solution_with(solution, ""), call.name)
    case = Case(**wrong.arguments(function, call.case))
    return answer(solution, "", ComparedCall(call.name, case, None, None))


@dataclass(frozen=True)
class _InPlace:
    """The solution with a variant in the place of one of its functions, whatever its others make of it."""

    solution: str
    name: str
    transform: Transform

    def __call__(self, call: Call) -> Numbers:
        try:
            return computed(self._module, call)
        except (LookupError, TypeError, AttributeError):
            return None

    @functools.cached_property
    def _module(self) -> ModuleType:
        module = solution_with.__wrapped__(self.solution, "")  # its own
        reference = getattr(module, self.name)

        def varied(*args: Numbers, **kwargs: Numbers) -> Numbers:
            return self.transform(ComparedCall(self.name, Case(*args, **kwargs), None, reference(*args, **kwargs)))

        setattr(module, self.name, varied)
        return module


def _explains(transform: Transform, calls: Sequence[ComparedCall]) -> bool:
    return all(call.fits(_quietly(transform, call)) for call in calls)


def _quietly(transform: Transform, call: ComparedCall) -> Numbers:
    """Return the answer of a variant; None where it has none, whatever is in its way."""
    count(1 + sum(map(np.size, parts(call.expected))) // ELEMENTS)
    try:
        with np.errstate(all="ignore"), warnings.catch_warnings(action="ignore"), limited(OF_ONE):
            return transform(call)
    except (Exhausted, ArithmeticError, LookupError, TypeError, ValueError, AttributeError, NameError):
        return None


def _mutant(
    solution: str, module: ModuleType, name: str, calls: Sequence[ComparedCall]
) -> tuple[str, list[str]] | None:
    """Say of the mutants that explain all calls, if they are of one kind, and the functions with them."""
    public = set(inspect.signature(getattr(module, name)).parameters)
    texts: dict[str, dict[str, str]] = {}
    factors = set[str]()
    numbers_last = sorted(_mutants(solution), key=lambda mutant: mutant[1] == KINDS["a number"])
    for helper, words, names_in_term, factor, text in numbers_last:
        if texts and words == KINDS["a number"]:
            break
        term = ", ".join(sorted(names_in_term & public))
        if helper in reached(solution)[name] and term not in texts.get(words, ()):
            with _with_mutant(module, helper, _code(text)):
                if _explains(partial(_called, module), calls):
                    texts.setdefault(words, {})[term] = text
                    factors.add(factor)
    if len(texts) > 1:
        texts.pop(KINDS["a factor"], None)  # a number is in the term that counts twice
    if len(texts) != 1:
        return None
    ((words, by_term),) = texts.items()
    if len(factors) == 1 and (factor := factors.pop()):
        return f"In {name}, {factor}", list(by_term.values())
    (term,) = by_term if len(by_term) == 1 else ("",)
    return f"In {name}, {words.format(f' with {term}' if term else '')}", list(by_term.values())


def _called(module: ModuleType, call: ComparedCall) -> Numbers:
    return getattr(module, call.name)(*call.case.args, **call.case.kwargs)


def shared_mutants(text: str, name: str, other: str, calls: Sequence[Call]) -> tuple[Answer, ...]:
    """Return the mutants of what two functions of a text share, that explain all calls of the first."""
    reach_of = reached(text)
    if not {name, other} <= reach_of.keys() or not reach_of[name] & reach_of[other]:
        return ()
    try:
        with limited(MOST):
            module = solution_with.__wrapped__(text, "")  # its own, to put mutants in
            mutant = _mutant(text, module, name, _compared(text, calls))
    except Exhausted:
        return ()
    return tuple(partial(answer, text, changed) for changed in mutant[1]) if mutant else ()


def _single_entry(name: str, calls: Sequence[ComparedCall]) -> str | None:
    """Return where a matrix or a vector in space is wrong, if it is in one place, and the others are not mere zeros."""
    forms = {np.shape(answer_of) for call in calls for answer_of in (call.result, call.expected)}
    if len(forms) > 1 or not (len(form := forms.pop()) == 2 or form == (SPACE,)):
        return None
    off = [np.abs(call.result - call.expected) > WITHIN * np.abs(call.expected).max() for call in calls]
    places = np.argwhere(np.any(off, axis=0))
    if len(places) != 1 or (len(form) == 1 and not np.any([call.expected for call in calls], axis=0).all()):
        return None
    where = ", ".join(f"{axis} {place + 1}" for axis, place in zip(AXES[len(form)], places[0], strict=True))
    return f"Your result of {name} is wrong in {where} alone"


@contextmanager
def _with_mutant(module: ModuleType, helper: str, code: CodeType) -> Iterator[None]:
    reference = getattr(module, helper)
    exec(code, vars(module))
    try:
        yield
    finally:
        setattr(module, helper, reference)


@functools.cache
def _mutants(solution: str) -> list[tuple[str, str, set[str], str, str]]:
    """Of each mutant that has words: the function, the words, the names in the term, the factor it lacks, its text."""
    parameters, locals_of = _unpacked(solution), _locals(solution)
    return [
        (
            function,
            words,
            {
                parameters.get(name, name)
                for name in names_used(mutant.product if isinstance(term, ast.Constant) else term)
            },
            _missing(mutant, term, locals_of[function]) if mutant.operator == "a missing factor" else "",
            mutant.text,
        )
        for function, mutants in mutants_of(solution).items()
        for mutant in mutants
        for words, term in _words(mutant)
    ]


def _unpacked(solution: str) -> dict[str, str]:
    """Return what the parts of an argument are called: `m1, m2 = masses`."""
    return {
        part.id: node.value.id
        for node in ast.walk(ast.parse(solution))
        if isinstance(node, ast.Assign) and isinstance(node.value, ast.Name) and isinstance(node.targets[0], ast.Tuple)
        for part in node.targets[0].elts
        if isinstance(part, ast.Name)
    }


def _locals(solution: str) -> dict[str, dict[str, ast.expr]]:
    """For each function the quantities that it computes, each from an expression, beside its parameters."""
    assigned: dict[str, dict[str, ast.expr]] = {}
    for function in (node for node in ast.parse(solution).body if isinstance(node, ast.FunctionDef)):
        arguments = function.args
        quantities = assigned[function.name] = {
            side.arg: ast.Name(side.arg) for side in (*arguments.args, *arguments.kwonlyargs)
        }  # those stand for themselves
        for node in ast.walk(function):
            if isinstance(node, ast.Assign) and len(node.targets) == 1:
                targets, values = (getattr(side, "elts", [side]) for side in (node.targets[0], node.value))
                targets_alone = [ast.Name(target.id) for target in targets if isinstance(target, ast.Name)]
                pairs = zip(targets, values if len(values) == len(targets) else targets_alone, strict=False)
                quantities |= {target.id: value for target, value in pairs if isinstance(target, ast.Name)}
    return assigned


def _missing(mutant: Mutant, factor: ast.expr, quantities: Mapping[str, ast.expr]) -> str:
    """Return what is missing, and beside which parameters; "" if it has no short name."""
    words, names = _in_parameters(factor, quantities), names_used(mutant.product) - names_used(factor)
    beside = ", ".join(sorted(name for name in names if ast.unparse(quantities.get(name, mutant.product)) == name))
    divides = isinstance(mutant.was, ast.BinOp) and isinstance(mutant.was.op, ast.Div)
    what = "division by" if divides else "factor"
    return words and f"the {what} {words} is missing{beside and f' beside {beside}'}"


def _in_parameters(term: ast.expr, quantities: Mapping[str, ast.expr]) -> str:
    """Return a factor as a student may have written it; "" if that is long, or not of parameters alone."""

    class InParameters(ast.NodeTransformer):
        def visit_Name(self, node: ast.Name) -> ast.expr:
            value = quantities.get(node.id, node)
            return value if isinstance(value, ast.Name) or isinstance(node.ctx, ast.Store) else self.visit(value)

    try:
        text = ast.unparse(InParameters().visit(copy.deepcopy(term)))
    except RecursionError:  # it is computed from itself
        return ""
    words = re.sub(r"\b(math|np|numpy)\.", "", text)
    return (
        words if len(words) <= LONGEST and set(re.findall(r"[A-Za-z_]\w*", words)) <= quantities.keys() | WORDS else ""
    )


LONGEST, WORDS = 24, {"sin", "cos", "tan", "sqrt", "exp", "pi"}


@functools.cache
def _code(text: str) -> CodeType:
    return compile_counted(text, "<mutant>", in_python=True)


def _words(mutant: Mutant) -> Iterator[tuple[str, ast.expr]]:
    """Yield what a student reads of a mutant, and the term that it is about."""
    was, now = mutant.was, mutant.now
    if mutant.operator in ("linearised", "a product for a square", "a missing square"):
        yield KINDS[mutant.operator], was
    elif mutant.operator == "a missing factor" and isinstance(was, ast.BinOp):
        dropped = was.right if now is was.left else was.left
        is_two = isinstance(dropped, ast.Constant) and dropped.value in (2, 0.5)
        yield KINDS["a factor"] if is_two else "a factor{} is missing", dropped
    elif mutant.operator == "a first sign" and isinstance(was, ast.BinOp):
        yield KINDS["a sign"], was.left
    elif isinstance(was, ast.BinOp) and isinstance(was.op, ast.Add | ast.Sub):
        if now in (was.left, was.right):
            yield "a term{} is missing", was.left if now is was.right else was.right
        elif isinstance(now, ast.BinOp) and now.right is was.right:
            yield "the sign of a term{} is reversed", was.right
        else:
            yield "a term{} counts twice", was.right
    elif isinstance(was, ast.BinOp) and isinstance(was.op, ast.Mult | ast.Div) and mutant.operator != "an exponent":
        multiplied = isinstance(was.op, ast.Mult)
        yield f"a factor{{}} {'divides' if multiplied else 'multiplies'} where it should not", was.right
    elif isinstance(was, ast.BinOp) and isinstance(was.op, ast.MatMult):
        yield KINDS["a transpose"], was
    elif isinstance(was, ast.Call) and mutant.operator == "another function" and any(map(_is_half, was.args)):
        yield "a cosine{} has the wrong sign", was  # 2 sin(x/2)^2 is 1 - cos x
    elif mutant.operator in KINDS:
        yield KINDS[mutant.operator], was


def _is_half(node: ast.expr) -> bool:
    numbers = [part.value for part in ast.walk(node) if isinstance(part, ast.Constant)]
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
