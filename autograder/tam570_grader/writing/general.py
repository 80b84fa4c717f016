"""Mistakes that nobody has written down: a sign, a factor, a swapped pair, degrees, a missing term, found by trying.

Where no known mistake gives the student's numbers, two families of variants are tried on the same inputs. The first
changes the arguments or the result of the right function; the second makes one slip in the solution's own code. A
variant is named if it alone explains every call of the check, of which at least two are wrong.
"""

import ast
import functools
import inspect
import math
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from itertools import combinations, permutations
from types import CodeType, ModuleType
from typing import Any

import numpy as np

from tam570_grader.writing.check import Given
from tam570_grader.writing.mistakes import Called, agrees, is_motion, parts, right_answer
from tam570_grader.writing.slips import Slip, reached, slips

__all__ = ["general"]

FEWEST = 2  # wrong calls: one may agree by chance
TELLING = 1e-3  # of the right answer: what is smaller may be what cancels
SPACE = 3  # components of a vector
ORDINALS = ("first ", "second ", "third ", "fourth ", "fifth ", "sixth ")  # results of a function
AXES = {1: ("component",), 2: ("row", "column"), 3: ("segment", "end", "component")}  # of an array, by their number
MOST = 6  # along an axis, of which one, or two, may be wrong
Variant = tuple[str, Callable[[Given], Any]]  # what to say, and the wrong answer
FACTORS = {
    "has the opposite sign": -1.0,
    "is twice as large as the right one": 2.0,
    "is half as large as the right one": 0.5,
    "is in degrees": 180 / math.pi,
    "lacks the factor pi": 1 / math.pi,
    "lacks the factor 2 pi": 1 / (2 * math.pi),
    "has a factor pi too many": math.pi,
    "has a factor 2 pi too many": 2 * math.pi,
    "lacks the factor sqrt(2)": math.sqrt(0.5),
    "has a factor sqrt(2) too many": math.sqrt(2),
}
POWERS: dict[str, Callable[[Any], Any]] = {
    "is the square of the right one": np.square,
    "is the square root of the right one": np.sqrt,
    "is one over the right one": np.reciprocal,
    "has lost its sign": np.abs,
}
GRAVITY = 9.81  # m/s^2
TURNS = 200  # of a loop: a bisection to the last digit takes 60, and a slip may go round for ever


def general(solution: str, calls: Sequence[Called]) -> str | None:
    """What to say of the one variant of the right answers that has the student's numbers in every call, or None.

    Motions and formulas are left out: two integrations of one wrong equation differ, and a formula takes long.
    """
    if any(call.result is None or is_motion(call) or _symbolic(call) for call in calls):
        return None
    expected = [right_answer(solution, call) for call in calls]
    wrong = [(call, right) for call, right in zip(calls, expected, strict=True) if not agrees(call.result, right)]
    names = {call.name for call, _ in wrong}
    if len(names) != 1 or any(right is None for right in expected):
        return None
    (name,) = names
    own = [call for call in calls if call.name == name]
    if not any(np.any(part) for call in own for part in parts(call.result)):
        return f"The result of {name} is zero"
    if _telling(wrong) < FEWEST:
        return None
    module = ModuleType("_varied")  # its own, to make slips in
    exec(_code(solution), vars(module))
    right = getattr(module, name)
    results, arguments = _other_results(name, right, own[0]), _other_arguments(name, right, own[0])
    if said := next((says for says, variant in results if _explains(variant, own)), ""):
        return said
    for family in (arguments, _other_products(name, right, own[0])):
        told = [says for says, variant in family if _explains(variant, own)]
        if len(told) == 1:
            return told[0]
    return _slip(solution, module, name, calls)


def _telling(wrong: Sequence[tuple[Called, Any]]) -> int:
    """How many different results they have that are more than rounding beside the right ones: zeros tell nothing."""
    results = set()
    for call, right in wrong:
        found, expected = (np.concatenate([np.ravel(one) for one in parts(result)]) for result in (call.result, right))
        if np.abs(found).max(initial=0.0) > TELLING * np.abs(expected).max(initial=0.0):
            results.add(found.tobytes())
    return len(results)


def _symbolic(call: Called) -> bool:
    args = call.given.args
    return bool(args) and isinstance(args[0], list) and isinstance(args[0][0], dict)


def _explains(variant: Callable[[Given], Any], calls: Sequence[Called]) -> bool:
    return all(agrees(call.result, _quietly(variant, call.given)) for call in calls)


def _quietly(variant: Callable[[Given], Any], given: Given) -> Any:
    """The answer of a variant; None where it has none, whatever is in its way."""
    try:
        with np.errstate(all="ignore"):
            return variant(given)
    except (ArithmeticError, LookupError, TypeError, ValueError, AttributeError, NameError, np.linalg.LinAlgError):
        return None


# What is given, and what comes out


def _other_results(name: str, right: Callable[..., Any], example: Called) -> Iterator[Variant]:
    results = parts(example.result)
    numbers = [key for key, value in example.given.kwargs.items() if np.ndim(value) == 0]
    for which, (place, found) in enumerate(zip(ORDINALS, results, strict=False)):
        label = f"The {place}result of {name}" if len(results) > 1 else f"The result of {name}"
        for says, change in _changes(np.asarray(found), numbers):
            yield f"{label} {says}", partial(_with_result, right, which, len(results), change)
    if len(results) > 1:
        yield f"The results of {name} have the opposite sign", partial(_reversed, right)


def _other_arguments(name: str, right: Callable[..., Any], example: Called) -> Iterator[Variant]:
    taken = list(inspect.signature(right).parameters)
    values = _named(taken, example.given)
    for key, value in values.items():
        for says, change in _other_values(np.asarray(value)):
            yield f"In {name}, {says.format(key)}", partial(_with_argument, right, taken, key, change)
    if "gravity" in values:
        says = f"In {name}, gravity is ignored, as if it were {GRAVITY}"
        yield says, partial(_with_argument, right, taken, "gravity", lambda value: GRAVITY)
    for one, other in combinations(values, 2):
        if np.shape(values[one]) == np.shape(values[other]):
            yield f"In {name}, {one} and {other} are exchanged", partial(_exchanged, right, taken, one, other)


def _other_products(name: str, right: Callable[..., Any], example: Called) -> Iterator[Variant]:
    """A factor that is missing beside an argument, or one too many."""
    taken = list(inspect.signature(right).parameters)
    values = {key: np.asarray(value) for key, value in _named(taken, example.given).items()}
    numbers = [key for key, value in values.items() if value.dtype.kind in "fiu"]
    for key, other in permutations(numbers, 2):
        if values[other].ndim == 0:
            missing, extra = (partial(_with_product, right, taken, key, other, power) for power in (-1, 1))
            yield f"In {name}, {key} lacks a factor {other}", missing
            yield f"In {name}, {key} has a factor {other} too many", extra


def _changes(found: Any, numbers: Sequence[str]) -> Iterator[tuple[str, Callable[[Any, Given], Any]]]:
    """What may be wrong with a result."""
    for says, factor in FACTORS.items():
        yield says, partial(_scaled, factor)
    for says, change in POWERS.items():
        yield says, partial(_changed, change)
    for key in numbers:
        for says, power in {"multiplied": -1, "divided": 1}.items():
            yield f"should be {says} by {key}", partial(_times, key, power)
            yield f"should be {says} by {key} squared", partial(_times, key, 2 * power)
    if found.ndim == 2 and found.shape[0] == found.shape[1]:
        yield "is transposed", lambda value, given: np.transpose(value)
    for says, change in _components(found):
        yield says, partial(_changed, change)


def _scaled(factor: float, value: Any, given: Given) -> Any:
    return value * factor


def _times(key: str, power: int, value: Any, given: Given) -> Any:
    return value * given.kwargs[key] ** power


def _changed(change: Callable[[Any], Any], value: Any, given: Given) -> Any:
    return change(value)


def _components(found: Any) -> Iterator[tuple[str, Callable[[Any], Any]]]:
    """One component of a vector, one row or column, of the wrong sign; two exchanged."""
    for axis, (what, count) in enumerate(zip(AXES.get(found.ndim, ()), found.shape, strict=False)):
        numbers = range(count if count <= MOST else 0)
        for k in numbers:
            yield f"has the opposite sign in {what} {k + 1}", partial(_negated, k, axis)
        for j, k in combinations(numbers, 2):
            order = np.arange(count)
            order[[j, k]] = k, j
            yield f"has {what}s {j + 1} and {k + 1} exchanged", partial(_ordered, order, axis)


def _negated(which: int, axis: int, value: Any) -> Any:
    signs = np.where(np.arange(np.shape(value)[axis]) == which, -1.0, 1.0)
    return np.moveaxis(np.moveaxis(np.asarray(value), axis, -1) * signs, -1, axis)


def _ordered(order: Any, axis: int, value: Any) -> Any:
    return np.take(value, order, axis)


VALUES: dict[str, Callable[[Any], Any]] = {
    "{} has the opposite sign": np.negative,
    "{} is converted to degrees": np.degrees,
    "{} is read as degrees": np.radians,
    "{} counts twice": partial(np.multiply, 2.0),
    "{} counts half": partial(np.multiply, 0.5),
    "{} is ignored, as if it were zero": partial(np.multiply, 0.0),
}


def _other_values(value: Any) -> Iterator[tuple[str, Callable[[Any], Any]]]:
    """What an argument may be taken for."""
    if value.dtype.kind not in "fiu":
        return
    if value.ndim != 1 or len(value) <= SPACE:  # a state is many things, and not one that has a sign
        yield from VALUES.items()
    if value.ndim == 0:
        yield "{} is ignored, as if it were 1", lambda one: 1.0
    if value.ndim == 2 and value.shape[0] == value.shape[1]:
        yield "{} is transposed", np.transpose
    for says, change in _components(value):
        yield f"{{}} {says}", change


def _with_result(right: Callable[..., Any], which: int, count: int, change: Any, given: Given) -> Any:
    whole = right(*given.args, **given.kwargs)
    results = parts(whole) if count > 1 else [whole]  # a vector may be a tuple of numbers
    results[which] = change(np.asarray(results[which]), given)
    return tuple(results) if count > 1 else results[0]


def _reversed(right: Callable[..., Any], given: Given) -> Any:
    return tuple(np.negative(one) for one in parts(right(*given.args, **given.kwargs)))


def _with_argument(right: Callable[..., Any], taken: Sequence[str], key: str, change: Any, given: Given) -> Any:
    values = _named(taken, given)
    return right(**{**values, key: change(values[key])})


def _with_product(
    right: Callable[..., Any], taken: Sequence[str], key: str, other: str, power: int, given: Given
) -> Any:
    values = _named(taken, given)
    return right(**{**values, key: np.asarray(values[key]) * float(values[other]) ** power})


def _exchanged(right: Callable[..., Any], taken: Sequence[str], one: str, other: str, given: Given) -> Any:
    values = _named(taken, given)
    return right(**{**values, one: values[other], other: values[one]})


def _named(taken: Sequence[str], given: Given) -> dict[str, Any]:
    return {**dict(zip(taken, given.args, strict=False)), **given.kwargs}


# The solution's own terms


def _slip(solution: str, module: ModuleType, name: str, calls: Sequence[Called]) -> str | None:
    """What to say of the slips that explain all calls, if they are of one kind."""
    public = set(inspect.signature(getattr(module, name)).parameters)
    found: dict[str, set[str]] = {}
    for helper, kind, terms, text in _slips(solution):
        term = ", ".join(sorted(terms & public))
        if helper in _reached(solution)[name] and term not in found.get(kind, ()):
            with _slipped(module, helper, _code(text)):
                if all(agrees(one.result, _quietly(partial(_called, module, one.name), one.given)) for one in calls):
                    found.setdefault(kind, set()).add(term)
    if len(found) > 1:
        found.pop(KINDS["a factor"], None)  # a number is in the term that counts twice
    if len(found) != 1:
        return None
    ((kind, told),) = found.items()
    (term,) = told if len(told) == 1 else ("",)
    return f"In {name}, {kind.format(f' with {term}' if term else '')}"


def _called(module: ModuleType, name: str, given: Given) -> Any:
    return getattr(module, name)(*given.args, **given.kwargs)


@contextmanager
def _slipped(module: ModuleType, helper: str, code: CodeType) -> Iterator[None]:
    right = getattr(module, helper)
    exec(code, vars(module))
    try:
        yield
    finally:
        setattr(module, helper, right)


@functools.cache
def _reached(solution: str) -> dict[str, set[str]]:
    return reached(solution)


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
    """Code in which every loop ends."""
    if "while" not in text:  # to make a tree of it takes six times as long as to compile it
        return compile(text, "<slip>", "exec")
    return compile(ast.fix_missing_locations(_Turns().visit(ast.parse(text))), "<slip>", "exec")


class _Turns(ast.NodeTransformer):
    """Gives a loop so many turns, and IndexError after them."""

    def visit_While(self, loop: ast.While) -> list[ast.stmt]:  # noqa: N802
        self.generic_visit(loop)
        left = f"_turns_{loop.lineno}"
        loop.test = ast.BoolOp(ast.And(), [ast.parse(f"{left}.pop()", mode="eval").body, loop.test])
        return [*ast.parse(f"{left} = [True] * {TURNS}").body, loop]


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
