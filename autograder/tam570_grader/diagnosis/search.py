"""Mistakes that nobody has written down: a sign, a factor, a swapped pair, degrees, a missing term, found by trying.

Where no known mistake gives the student's numbers, two families of variants are tried on the same inputs. The first
changes the arguments or the result of the right function; the second makes one slip in the solution's own code. A
variant is named if it alone explains every call of the check, of which at least two are wrong.
"""

import ast
import functools
import inspect
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from types import CodeType, ModuleType
from typing import Any

import numpy as np

from tam570_grader.checks.effort import Exhausted, compile_counted, count, limited
from tam570_grader.diagnosis.compared_call import Judged, judged, telling
from tam570_grader.diagnosis.mistakes import WITHIN, Called, parts, right_answer
from tam570_grader.diagnosis.mutants import Slip, reached, slips
from tam570_grader.diagnosis.transforms import other_arguments, other_products, other_results

__all__ = ["general"]

FEWEST = 2  # wrong answers: one may agree by chance
MOST = 1_000_000  # steps of all variants, about a second; what is named takes a third of them
OF_ONE = 100_000  # steps of one variant in one call: a slip may go round for ever
ELEMENTS = 1000  # of a result, that are compared in a step


def general(solution: str, calls: Sequence[Called]) -> str | None:
    """What to say of the one variant of the right answers that has the student's numbers in every call, or None.

    Formulas are left out: to evaluate one takes long.
    """
    try:
        with limited(MOST):
            return _general(solution, calls)
    except Exhausted:
        return None


def _general(solution: str, calls: Sequence[Called]) -> str | None:
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
        return f"The result of {name} is zero"
    if telling(wrong) < FEWEST:
        return None
    module = ModuleType("_varied")  # its own, to make slips in
    exec(_code(solution), vars(module))
    right = getattr(module, name)
    known_for = {str(call.case.kwargs) for call in wrong}
    results = other_results(name, wrong[0], vary=len(known_for) >= FEWEST or not wrong[0].case.kwargs)
    if said := next((says for says, variant in results if _explains(variant, own)), ""):
        return said
    for family in (other_arguments(name, right, own[0]), other_products(name, right, own[0])):
        told = [says for says, variant in family if _explains(variant, own)]
        if len(told) == 1:
            return told[0]
    return _slip(solution, module, name, known) or _single_entry(name, own)


def _symbolic(call: Called) -> bool:
    args = call.case.args
    return bool(args) and isinstance(args[0], list) and isinstance(args[0][0], dict)


def _explains(variant: Callable[[Judged], Any], calls: Sequence[Judged]) -> bool:
    return all(call.fits(_quietly(variant, call)) for call in calls)


def _quietly(variant: Callable[[Judged], Any], call: Judged) -> Any:
    """The answer of a variant; None where it has none, whatever is in its way."""
    count(1 + sum(map(np.size, parts(call.right))) // ELEMENTS)
    try:
        with np.errstate(all="ignore"), limited(OF_ONE):
            return variant(call)
    except (Exhausted, ArithmeticError, LookupError, TypeError, ValueError, AttributeError, NameError):
        return None


def _slip(solution: str, module: ModuleType, name: str, calls: Sequence[Judged]) -> str | None:
    """What to say of the slips that explain all calls, if they are of one kind."""
    public = set(inspect.signature(getattr(module, name)).parameters)
    found: dict[str, set[str]] = {}
    for helper, kind, terms, text in _slips(solution):
        term = ", ".join(sorted(terms & public))
        if helper in reached(solution)[name] and term not in found.get(kind, ()):
            with _slipped(module, helper, _code(text)):
                if _explains(partial(_called, module), calls):
                    found.setdefault(kind, set()).add(term)
    if len(found) > 1:
        found.pop(KINDS["a factor"], None)  # a number is in the term that counts twice
    if len(found) != 1:
        return None
    ((kind, told),) = found.items()
    (term,) = told if len(told) == 1 else ("",)
    return f"In {name}, {kind.format(f' with {term}' if term else '')}"


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
def _slips(solution: str) -> list[tuple[str, str, set[str], str]]:
    """Of each slip that has words: the function, the words, the names in the term, and the function's text with it."""
    return [
        (function, words, {node.id for node in ast.walk(term) if isinstance(node, ast.Name)}, slip.text)
        for function, known in slips(solution).items()
        for slip in known
        for words, term in _words(slip)
    ]


@functools.cache
def _code(text: str) -> CodeType:
    return compile_counted(text, "<slip>", in_python=True)


def _words(slip: Slip) -> Iterator[tuple[str, ast.expr]]:
    """What a student reads of a slip, and the term that it is about."""
    was, now = slip.was, slip.now
    if slip.operator == "a missing factor" and isinstance(was, ast.BinOp):
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
    "another function": "the wrong function is used{}, such as sine for cosine",
    "swapped arguments": "two quantities{} are exchanged",
    "an index": "the wrong component is used{}",
    "a transpose": "matrices{} are multiplied in the wrong order, or one is transposed",
}
