"""Known mistakes: wrong submissions, each written once, which test the checks and which feedback names.

They are decorated functions in the file `mistakes.py` beside the checks:

    @mistake(first_fails=checks.solution_is_the_motion)
    def solution(reference, *args, gravity, **parameters):
        '''You let gravity pull up; it pulls down.'''
        return reference(*args, gravity=-gravity, **parameters)

`reference` is the solution's own function of that name, which may be one of its helpers. The body can use the
solution's names, and those that `mistakes.py` imports or defines. The file is read, never imported: checks grade the
solution with such a function in place of its own, in the sandbox, and diagnosis runs it on a student's inputs.
"""

import ast
import functools
import hashlib
import inspect
import math
import sys
from collections import Counter
from collections.abc import Callable, Container, Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from tam570.checking.transforms import parts
from tam570.meter import Exhausted, count, limited
from tam570.values import Function, Json, Numbers
from tam570_grader.checks.case import Call
from tam570_grader.checks.check import Check, LruCache
from tam570_grader.checks.effort import compile_counted
from tam570_grader.checks.expected import shared
from tam570_grader.diagnosis import fixed_steps
from tam570_grader.diagnosis.cause import Answer, Cause
from tam570_grader.diagnosis.mutants import reached
from tam570_grader.protocol.wire import packed

CANCELLED = 1e-14  # rounding error if numbers of order one cancel, and a wrong answer is exactly zero
WITHIN = 1e-6  # relative tolerance: with random inputs, mistakes differ by more
OF_MOTIONS = 1e-3  # relative tolerance: two integrations of one wrong equation differ by less
OF_A_STATE = 15  # numbers in a state, at most
MOST_ANSWERS = 2**26  # bytes in the cache; students with the same inputs share answers
MOST_CHANGES = 2**17  # cached comparisons of an answer with and without a mistake
OF_AN_ANSWER = 1000  # bytes per answer besides its numbers
MOST_STEPS = 500_000  # of an answer; a motion of a mistake takes a fifth at most, unless its steps become ever shorter


@dataclass(frozen=True)
class Mistake:
    """A wrong submission, as `mistake` declares it.

    name        : of the function, with a number from its second mistake on; or as the decorator says
    message     : the sentence for the student
    first_fails : the first check, in their order, that fails
    text        : definitions that make the mistake if they are appended to the solution
    tolerance   : largest difference from a student's numbers, relative to the largest; None: see `tolerance_of`
    label       : only inputs whose label contains it are compared
    compared    : False if a check itself names it, or nothing can: its numbers are not compared with a student's
    numerics    : whether the physics is right, but integrated inaccurately
    """

    name: str
    message: str
    first_fails: str
    text: str
    tolerance: float | None = None
    label: str = ""
    compared: bool = True
    numerics: bool = False

    @functools.cached_property
    def defined(self) -> frozenset[str]:
        """The names of the functions that it defines."""
        return frozenset(node.name for node in ast.parse(self.text).body if isinstance(node, ast.FunctionDef))


Body = TypeVar("Body", bound=Function)


def mistake(
    *,
    first_fails: Check,
    name: str = "",
    tolerance: float | None = None,
    label: str = "",
    compared: bool = True,
    numerics: bool = False,
) -> Callable[[Body], Body]:
    """Declare a known mistake in a function of the solution; `mistakes` reads the declaration from the file.

    The docstring of the function is what a student reads: "You ...; ...".

    Parameters
    ----------
    first_fails : the first check that fails
    name, tolerance, label, compared, numerics : see `Mistake`
    """
    return lambda function: function


FILE = "mistakes.py"
OVERLAY = """{besides}

_reference = {function}


{wrong}


def {function}(*args, **parameters):
    return _mistaken(_reference, *args, **parameters)
"""


@functools.cache
def mistakes(folder: Path) -> tuple[Mistake, ...]:
    """Return the known mistakes of the assignment with this folder of checks, in order."""
    path = folder / FILE
    return tuple(_decorated(path.read_text(encoding="utf-8"))) if path.exists() else ()


def overlays(folder: Path) -> dict[str, str]:
    """Return the source of each mistake, by name; appended to the solution, it makes a wrong submission."""
    return {known_mistake.name: known_mistake.text for known_mistake in mistakes(folder)}


def _decorated(text: str) -> Iterator[Mistake]:
    tree, count = ast.parse(text), Counter[str]()
    besides = "\n".join(_carried(node) for node in tree.body if not (_decorator(node) or _is_of_the_grader(node)))
    for node in tree.body:
        if decorator := _decorator(node):
            assert isinstance(node, ast.FunctionDef)
            count[function := node.name] += 1
            changed = {"name": "_mistaken", "decorator_list": [], "body": node.body[1:]}
            wrong = ast.unparse(ast.FunctionDef(**{**vars(node), **changed}))
            fields: Json = {str(field.arg): _value(field.value) for field in decorator.keywords}
            fields["name"] = fields.get("name") or function + (f"_{count[function]}" if count[function] > 1 else "")
            overlay = OVERLAY.format(besides=besides, function=function, wrong=wrong)
            message = " ".join((ast.get_docstring(node) or "").split())
            yield Mistake(message=message, text=overlay, **fields)


def _decorator(node: ast.stmt) -> ast.Call | None:
    """Return the call of `mistake` that decorates a function, else None."""
    decorators = node.decorator_list if isinstance(node, ast.FunctionDef) else []
    calls = [decorator for decorator in decorators if isinstance(decorator, ast.Call)]
    return next((call for call in calls if getattr(call.func, "id", "") == "mistake"), None)


def _carried(node: ast.stmt) -> str:
    """Return the source of a statement; for an import of `fixed_steps`, the source of that module."""
    is_steps = isinstance(node, ast.ImportFrom) and node.module == fixed_steps.__name__
    return inspect.getsource(fixed_steps) if is_steps else ast.unparse(node)


def _is_of_the_grader(node: ast.stmt) -> bool:
    """Return whether a statement is only for readers: the docstring, or an import of checks or of `mistake`."""
    imported = isinstance(node, ast.ImportFrom) and (node.level > 0 or node.module == __name__)
    return imported or (isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant))


def _value(node: ast.expr) -> object:
    """Return the value of a literal, or the name of a check."""
    is_check = isinstance(node, ast.Name | ast.Attribute)
    return ast.unparse(node).rpartition(".")[2] if is_check else ast.literal_eval(node)


def candidates(solution: str, folder: Path, functions: Container[str]) -> list[Mistake]:
    """Return the mistakes that numbers can show, and that change one of these functions or a function that it uses."""
    reach_of = frozenset().union(*(reach for name, reach in reached(solution).items() if name in functions))
    return [
        known_mistake
        for known_mistake in mistakes(folder)
        if known_mistake.compared and known_mistake.defined & reach_of
    ]


def named_mistake(solution: str, suspects: Iterable[Mistake], calls: Sequence[Call]) -> Cause | None:
    """Return the cause for the first mistake that agrees with the calls; None if there is none.

    Every result of each function that the mistake changes must be the mistake's, and one must be numbers.
    """
    short_first = sorted(calls, key=lambda call: len(call.case.packed))  # a motion of a few rows excludes most mistakes
    groups = {name: [call for call in short_first if call.name == name] for name in {call.name for call in calls}}
    mistake = next((candidate for candidate in suspects if _explains_all(solution, candidate, groups)), None)
    if mistake is None:
        return None
    wrong = [call.name for call in calls if _changed(solution, mistake.text, call, tolerance_of(call))]
    answers = (functools.partial(answer, solution, mistake.text),)
    return Cause((wrong or [calls[0].name])[0], mistake.message, "known mistake", answers, tuple(calls))


def explains(solution: str, answer_to: Answer, calls: Sequence[Call]) -> bool:
    """Return whether the solution with a mistake in it gives what the student's functions returned in every call.

    Some result must be wrong because of it, and some number must not be zero, because zeros follow from many mistakes.
    A right result, as in a case with its own branch, needs no explanation.
    """
    wrong = informative = False
    for call in sorted(calls, key=lambda call: len(call.case.packed)):
        correct, tolerance = answer(solution, "", call), tolerance_of(call)
        if same(call.result, correct, tolerance):
            continue
        expected = answer_to(call)
        if expected is None or not same(call.result, expected, tolerance):
            return False
        wrong = wrong or not same(expected, correct, tolerance)
        informative = informative or largest(call.result) > CANCELLED
    return wrong and informative


def _explains_all(solution: str, mistake: Mistake, groups: dict[str, list[Call]]) -> bool:
    informative = False
    compared = ([call for call in group if mistake.label in call.case.label] for group in groups.values())
    for group in filter(None, compared):
        tolerance = mistake.tolerance or tolerance_of(group[0])
        changed = (_changed(solution, mistake.text, call, tolerance) for call in group)
        size = max(1.0, *(largest(call.result) for call in group))  # relative to it, a result may cancel to rounding
        if all(same(call.result, answer(solution, mistake.text, call), tolerance, size) for call in group):
            informative = informative or (any(changed) and any(call.result is not None for call in group))
        elif any(changed):
            return False
    return informative


def tolerance_of(call: Call) -> float:
    """Return the tolerance, relative to the largest number: larger for rows of a motion, or a quadrature."""
    samples = (call.case.args or (None,))[0]
    is_integral = np.ndim(parts(call.result)[0]) == 0 and np.ndim(samples) == 1 and np.size(samples) > OF_A_STATE
    return OF_MOTIONS if is_integral or is_motion(call) else WITHIN


def is_motion(call: Call) -> bool:
    """Return whether the result has a row for each of the times; a square result is the matrix of a vector."""
    times, shape = (call.case.args or (None,))[0], np.shape(parts(call.result)[0])
    return isinstance(times, np.ndarray) and len(shape) > 1 and times.shape == shape[:1] != shape[-1:]


def right_answer(solution: str, call: Call) -> Numbers:
    """Return the solution's answer to a call; None if it has none."""
    value = answer(solution, "", call)
    return None if value is NoValue else value


class NoValue:
    """Value in place of an answer: a wrong formula may have none for inputs for which the right one has a value."""


_answers = LruCache[Numbers](MOST_ANSWERS, lambda answer: OF_AN_ANSWER + 8 * sum(map(np.size, parts(answer))))
_changes = LruCache[bool](MOST_CHANGES)


def answer(solution: str, text: str, call: Call) -> Numbers:
    """Return the answer of the solution with a mistake, cached for all students who have the same input."""
    name, message = _named(solution, text), call.case.packed

    def compute() -> Numbers:
        return shared(
            call.name, name, packed(call.name) + message, lambda: _limited(solution_with(solution, text), call)
        )

    return _answers.value((name, call.name, message), compute)


def _changed(solution: str, text: str, call: Call, tolerance: float) -> bool:
    """Return whether the mistake changes the answer to a call."""
    key = _named(solution, text), call.name, call.case.packed, tolerance

    def compute() -> bool:
        return not same(answer(solution, "", call), answer(solution, text, call), tolerance)

    return _changes.value(key, compute)


@functools.lru_cache(maxsize=256)
def _named(solution: str, text: str) -> str:
    return hashlib.sha256(f"{solution}\0{text}".encode()).hexdigest()


def computed(module: ModuleType, call: Call) -> Numbers:
    """Return the answer of a module's function to a call; `NoValue` if it raises an arithmetic or value error."""
    function, case = getattr(module, call.name), call.case
    try:
        with np.errstate(all="ignore"):
            if case.points:
                import sympy

                symbols = [sympy.Symbol(name) for name in case.points[0]]
                value = sympy.lambdify(symbols, function(), "numpy")
                return np.array([value(*point.values()) for point in case.points], float)
            return function(*case.args, **case.kwargs)
    except (ArithmeticError, ValueError, np.linalg.LinAlgError):
        return NoValue


def _limited(module: ModuleType, call: Call) -> Numbers:
    """Return the answer of a module's function to a call; `NoValue` also if it takes more than `MOST_STEPS`."""
    try:
        with limited(MOST_STEPS):
            return computed(module, call)
    except Exhausted:
        count(0)  # raises it again if the steps of the whole diagnosis are spent
        return NoValue


@functools.lru_cache(maxsize=256)
def solution_with(solution: str, text: str) -> ModuleType:
    """Return the solution as a new module, in which the definitions of the mistake replace its own."""
    module = sys.modules["_mistaken"] = ModuleType("_mistaken")  # a dataclass looks for its module there
    for part in (solution, text):
        exec(_code(part, "<mistake>"), vars(module))
    return module


_code = functools.lru_cache(maxsize=256)(compile_counted)


def same(result: Numbers, wrong: Numbers, tolerance: float, size: float = 1.0) -> bool:
    """Return whether two answers agree, relative to the largest number; answers without a value agree.

    size : of the numbers that cancel if a result is zero
    """
    if any(np.iscomplexobj(part) for part in parts(wrong)):
        return False  # a root of something negative; results are real
    if result is None or result is NoValue or wrong is NoValue:
        is_finite = wrong is not NoValue and all(np.isfinite(np.asarray(part, float)).all() for part in parts(wrong))
        return (result is None or result is NoValue) and not is_finite
    if isinstance(wrong, tuple) and not isinstance(result, tuple):
        wrong = np.asarray(wrong, float)  # the numbers of an array may be returned one by one
    pairs = list(zip(parts(result), parts(wrong), strict=False))
    return len(parts(result)) == len(parts(wrong)) and all(
        _close(first, other, tolerance, CANCELLED * size) for first, other in pairs
    )


def largest(result: Numbers) -> float:
    """Return the largest size of the finite numbers of a result, 0 if it has none."""
    sizes = np.abs(all_numbers(result))
    return float(sizes.max(initial=0.0, where=np.isfinite(sizes)))


def all_numbers(result: Numbers) -> NDArray[np.float64]:
    """Return all numbers of a result in one array; none for None, or for an answer without a value."""
    if result is None or result is NoValue:
        return np.array([])
    return np.concatenate([np.ravel(np.asarray(part, float)) for part in parts(result)])


def _close(result: Numbers, expected: Numbers, tolerance: float, rounding: float) -> bool:
    result, expected = np.asarray(result, float), np.asarray(expected, float)
    if result.shape != expected.shape:
        return False
    size = float(np.abs(expected).max(initial=0.0))
    if not math.isfinite(size):
        return bool(np.array_equal(result, expected))
    with np.errstate(all="ignore"):
        return bool((np.abs(result - expected) <= tolerance * size + rounding).all())
