"""Search for mistakes that nobody has written down: a sign, a factor, a swapped pair, degrees, a missing term.

If no known mistake gives the student's numbers, two families of variants are tried on the same inputs. The first
changes the arguments or the result of the right function; the second makes one slip in the solution's own code. A
variant is named if it is the only one that explains every call of the check, of which at least two are wrong.
"""

import ast
import copy
import functools
import inspect
import re
import warnings
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence, Set
from dataclasses import dataclass, replace
from functools import partial
from types import CodeType, ModuleType

import numpy as np

from tam570.checking.transforms import (
    AXES,
    LENGTHS,
    SPACE,
    WrongArgument,
    other_arguments,
    other_factors,
    other_forms,
    other_products,
    other_results,
    other_symbols,
    other_words,
    parts,
)
from tam570.meter import Exhausted, count, limited
from tam570.values import Function, Numbers
from tam570_grader.checks.case import Call, Case
from tam570_grader.checks.effort import compile_lightly
from tam570_grader.diagnosis.cause import Answer, Cause
from tam570_grader.diagnosis.compared_call import ComparedCall, beginning, compared_call
from tam570_grader.diagnosis.mistakes import WITHIN, answer, computed, is_motion, largest, right_answer, solution_with
from tam570_grader.diagnosis.mutants import Mutant, mutants_of, names_used, reached

FEWEST = 2  # wrong answers: a single one may agree by chance
MOST = 1_000_000  # steps of all variants, about a second; mistakes that are named take a third of them
OF_ONE = 100_000  # steps of one variant in one call: a mutant may loop forever
VAGUE = "counts twice", "counts half"  # a mutant is tried, too: it may be a missing number, or one too many
REVERSED = "has the opposite sign"
MISSING_TERM, MISSING_FACTOR = "a term{} is missing", "a factor{} is missing"
ELEMENTS = 1000  # of a result, compared in one step
FORMULA = 2_000  # steps for deriving and evaluating a formula
Transform = Callable[[ComparedCall], Numbers]


def general(
    solution: str, calls: Sequence[Call], others: Sequence[str] = (), passed: Set[str] = frozenset()
) -> Cause | None:
    """Return the only variant of the right answers that matches the student's numbers in every call, else None.

    others : sources of other right functions, in place of the solution's own
    passed : functions of the student that passed: mutants of these, and of what they use, are tried last
    """
    try:
        with limited(MOST):
            return _general(solution, calls, others, passed)
    except Exhausted:
        return None


def _compared(solution: str, calls: Sequence[Call]) -> list[ComparedCall]:
    """Return the calls beside the right answers; an empty list if one failed, or has no right answer."""
    if any(call.result is None for call in calls):
        return []
    expected, sizes = [right_answer(solution, call) for call in calls], dict[str, float]()
    for call in calls:
        sizes[call.name] = max(1.0, sizes.get(call.name, 0.0), largest(call.result))
    compared = [compared_call(call, value, sizes[call.name]) for call, value in zip(calls, expected, strict=True)]
    return [] if any(value is None for value in expected) else compared


def _general(solution: str, calls: Sequence[Call], others: Sequence[str], passed: Set[str]) -> Cause | None:
    compared = _compared(solution, calls)
    compared += filter(None, map(beginning, compared))
    # First the calls that rule out most variants, at the least cost.
    compared.sort(key=lambda call: (call.fits(call.expected), len(call.case.packed)))
    wrong = [call for call in compared if not call.fits(call.expected)]
    names = {call.name for call in wrong}
    if len(names) != 1:
        return None
    (name,) = names
    its_calls = [call for call in compared if call.name == name]
    if not any(np.any(part) for call in its_calls for part in parts(call.result)):
        return Cause(name, f"Your result of {name} is zero", "result")
    if len(set().union(*(call.numbers() for call in wrong))) < FEWEST:
        return None
    known_for = {str(call.case.kwargs) for call in wrong}
    module = ModuleType("_varied")  # a new one, into which mutants are put
    exec(_code(solution), vars(module))
    vary, right = len(known_for) >= FEWEST or not wrong[0].case.kwargs, getattr(module, name)

    def other_result(calls: Sequence[ComparedCall]) -> Cause | None:
        """Return the cause for the first wrong result that explains these calls."""
        results = other_results(name, right, wrong[0], vary=vary)
        return _transformed(solution, name, next(_explaining(results, calls), None), source="result")

    cause = (
        other_result(its_calls)
        or _other_symbol(solution, name, its_calls)
        or _other_argument(solution, module, name, its_calls)
    )
    if cause is None or cause.message.endswith(VAGUE):
        mutant = _mutant_of_any(solution, others, module, name, compared, passed)
        cause = mutant if mutant and not (cause and mutant.message.endswith(KINDS["halves"])) else cause
    cause = cause or _for_one_word(solution, others, module, name, its_calls, passed, other_result)
    if cause is None:  # any other change of an argument or a result, or the only place where the result is wrong
        reference = getattr(module, name)
        change = _either_reversed(name, reference, its_calls)
        change = change or next(_explaining(other_forms(name, reference, its_calls[0]), its_calls), None)
        cause = _transformed(solution, name, change) or _single_entry(solution, name, its_calls)
    return cause and replace(cause, calls=tuple(calls))


def _other_argument(solution: str, module: ModuleType, name: str, its_calls: Sequence[ComparedCall]) -> Cause | None:
    """Return the cause for a wrong argument, factor, product or word, if no other of its family explains the calls."""
    reference = getattr(module, name)
    families = (
        other_arguments(name, reference, its_calls[0]),
        other_factors(name, reference, its_calls[0]),
        other_products(name, reference, its_calls[0]),
        other_words(name, reference, [call.case for call in its_calls]),
    )
    explaining = ([*_explaining(family, its_calls)] for family in families)
    return _transformed(solution, name, next((variants[0] for variants in explaining if len(variants) == 1), None))


def _transformed(
    solution: str, name: str, change: tuple[str, Transform] | None, source: str = "transform"
) -> Cause | None:
    """Return the cause for a variant; None for None."""
    if change is None:
        return None
    words, transform = change
    return Cause(name, words, source, _with_variant(solution, name, transform))


def _other_symbol(solution: str, name: str, calls: Sequence[ComparedCall]) -> Cause | None:
    """Return the cause for the only wrong symbol of a formula that explains all calls."""
    changes = other_symbols(name, calls[0].case.args[0]) if calls[0].case.points else ()
    variants = ((words, partial(_at_other_points, solution, change)) for words, change in changes)
    explaining = {words: change for words, change in variants if _explains(change, calls)}
    return Cause(name, next(iter(explaining)), "transform", (*explaining.values(),)) if len(explaining) == 1 else None


def _at_other_points(solution: str, change: Callable[[Numbers], Numbers], call: Call) -> Numbers:
    """Return the value of the solution's formula with other values of its symbols; None for other functions."""
    if not call.case.points:
        return None
    points = Case(change(call.case.args[0]))
    return computed(solution_with(solution, ""), ComparedCall(call.name, points, None, None))


def _either_reversed(name: str, reference: Function, calls: Sequence[ComparedCall]) -> tuple[str, Transform] | None:
    """Return an argument of the wrong sign, with words for all arguments whose wrong sign gives the same numbers."""
    explaining = [*_explaining(other_arguments(name, reference, calls[0]), calls)]
    if not explaining or not all(words.endswith(REVERSED) for words, _ in explaining):
        return None
    (words, transform), *others = explaining
    return ", or ".join([words, *(other.removeprefix(f"In {name}, ") for other, _ in others)]), transform


def _explaining(
    family: Iterable[tuple[str, Transform]], calls: Sequence[ComparedCall]
) -> Iterator[tuple[str, Transform]]:
    """Yield the variants of a family that explain all calls."""
    return ((words, transform) for words, transform in family if _explains(transform, calls))


def _for_one_word(  # noqa: PLR0913  as `_mutant_of_any`
    solution: str,
    others: Sequence[str],
    module: ModuleType,
    name: str,
    calls: Sequence[ComparedCall],
    passed: Set[str],
    other_result: Callable[[Sequence[ComparedCall]], Cause | None],
) -> Cause | None:
    """Return the cause of answers that are wrong only if an argument is one certain word."""
    words = [[each for each in enumerate(call.case.args) if isinstance(each[1], str)] for call in calls]
    wrong = [each for each, call in zip(words, calls, strict=True) if not call.fits(call.expected)]
    only = next((each for each in wrong[0] if all(each in other for other in wrong)), None)
    there = [call for each, call in zip(words, calls, strict=True) if only in each]
    if not only or len(there) == len(calls):
        return None
    cause = other_result(there) or _other_argument(solution, module, name, there)
    cause = cause or _mutant_of_any(solution, others, module, name, there, passed)
    key = [*inspect.signature(getattr(module, name)).parameters][only[0]]

    def there_alone(wrong: Answer, call: Call) -> Numbers:
        return wrong(call) if only[1] in map(str, call.case.args) else answer(solution, "", call)

    answers = tuple(partial(there_alone, each) for each in cause.answers) if cause else ()
    return cause and replace(cause, message=f"{cause.message} where {key} is {only[1]!r}", answers=answers)


def wrong_arguments(solution: str, calls: Sequence[Call], before: Sequence[Call]) -> Iterator[Cause]:
    """Yield the cause for each wrong argument that explains all calls of a function.

    There may be several, one of which was made before, in calls that may have other words.
    """
    compared = _compared(solution, calls)
    if len({call.name for call in compared}) != 1:
        return
    name = compared[0].name
    reference = getattr(solution_with(solution, ""), name)
    exchanged = other_words(name, reference, [call.case for call in (*calls, *before)])
    for words, transform in (*other_arguments(name, reference, compared[0]), *exchanged):
        if isinstance(transform, WrongArgument) and _explains(transform, compared):
            yield Cause(name, words, "transform", _with_variant(solution, name, transform), tuple(calls))


def _with_variant(solution: str, name: str, transform: Transform) -> tuple[Answer, ...]:
    """Return answers of the solution with a variant of one function, or with a wrong argument, also in every one."""
    if isinstance(transform, WrongArgument):
        return partial(_everywhere, solution, transform), _InPlace(solution, name, transform)
    return (_InPlace(solution, name, transform),)


def _everywhere(solution: str, wrong: WrongArgument, call: Call) -> Numbers:
    if call.case.points:  # a formula has no arguments
        return None
    function = getattr(solution_with(solution, ""), call.name)
    case = Case(**wrong.arguments(function, call.case))
    return answer(solution, "", ComparedCall(call.name, case, None, None))


@dataclass(frozen=True)
class _InPlace:
    """The solution with a variant in place of one of its functions, which the others call."""

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
        module = solution_with.__wrapped__(self.solution, "")  # a new one, to be changed
        reference = getattr(module, self.name)

        def varied(*args: Numbers, **kwargs: Numbers) -> Numbers:
            try:
                expected = None if isinstance(self.transform, WrongArgument) else reference(*args, **kwargs)
            except ValueError:  # the variant may have a value
                expected = np.nan
            return self.transform(ComparedCall(self.name, Case(*args, **kwargs), None, expected))

        setattr(module, self.name, varied)
        return module


def _explains(transform: Transform, calls: Sequence[ComparedCall]) -> bool:
    return all(call.fits(_quietly(transform, call)) for call in calls)


def _quietly(transform: Transform, call: ComparedCall) -> Numbers:
    """Return the answer of a variant; None if it raises an exception, or takes too many steps."""
    count(FORMULA if call.case.points else 1 + sum(map(np.size, parts(call.expected))) // ELEMENTS)
    try:
        with np.errstate(all="ignore"), warnings.catch_warnings(action="ignore"), limited(OF_ONE):
            return transform(call)
    except (Exhausted, ArithmeticError, LookupError, TypeError, ValueError, AttributeError, NameError, RuntimeError):
        return None


def _mutant_of_any(
    solution: str, others: Sequence[str], module: ModuleType, name: str, calls: Sequence[ComparedCall], passed: Set[str]
) -> Cause | None:
    """Return the cause for mutants of the solution, or of it with other functions, that explain all calls."""
    public = set(inspect.signature(getattr(module, name)).parameters)
    for other in ("", *others):
        reach_of = reached(other or solution)
        reach = reach_of.get(name, set())
        likely = reach.difference(*(reach_of.get(each, ()) for each in passed))
        for suspects in filter(None, (likely, reach - likely)):  # a student's copy of a passed helper may be wrong
            exec(_code(other), vars(module))
            if mutant := _mutant(other or solution, module, name, calls, public, suspects):
                words, texts = mutant
                answers = tuple(partial(answer, solution, f"{other}\n{text}") for text in texts)
                return Cause(name, words, "mutant", answers)
    return None


def _mutant(
    solution: str, module: ModuleType, name: str, calls: Sequence[ComparedCall], public: Set[str], suspects: Set[str]
) -> tuple[str, list[str]] | None:
    """Return the words and sources of the mutants that explain all calls, if all have the same words; else None.

    public : the parameters of the function
    suspects : the functions of the solution that may have the slip
    """
    texts: dict[str, dict[str, str]] = {}
    factors, parameters = dict[str, set[str]](), _unpacked(solution)
    for helper, words, names_in_term, factor, text in sorted(_mutants(solution), key=lambda mutant: _rarity(mutant[1])):
        if any(_rarity(other) < _rarity(words) for other in texts):
            break
        term = ", ".join(sorted(name for name in names_in_term if {name, parameters.get(name)} & public))
        if helper in suspects and term not in texts.get(words, ()):
            reference = getattr(module, helper)
            exec(_code(text), vars(module))
            if _explains(partial(_called, module), calls):
                texts.setdefault(words, {})[term] = text
                factors.setdefault(words, set()).add(factor)
            setattr(module, helper, reference)
    if MISSING_FACTOR in texts:
        texts.pop(MISSING_TERM, None)  # without the term, the factor is 1
    if len(texts) > 1:
        texts.pop(KINDS["half a term"], None)  # the others name its missing factor, or the number
    if len(texts) > 1:
        texts.pop(KINDS["a factor"], None)  # the number is in the term that counts twice
        texts.pop(KINDS["two exchanged"], None)  # these are a sine and a cosine
        texts.pop(KINDS["linearised"], None)  # the cosine is the missing factor
    if len(texts) > 1:
        texts.pop(KINDS["ignored"], None)  # the quantity is the missing term
        texts = {words: by_term for words, by_term in texts.items() if not words.startswith("the result of")}
    if len(texts) != 1:
        return None
    ((words, by_term),) = texts.items()
    if len(factors[words]) == 1 and (factor := factors[words].pop()):
        return f"In {name}, {factor}", list(by_term.values())
    term = ", ".join(sorted(set.intersection(*(set(term.split(", ")) for term in by_term))))
    term = term or (" or ".join(sorted(by_term)) if len(by_term) == 2 and all(by_term) else "")
    return f"In {name}, {words.format(f' with {term}' if term else '')}", list(by_term.values())


def _rarity(words: str) -> int:
    """Return the rank of a kind of mutant, which is named only if none of a lower rank explains the calls."""
    if words in (KINDS["halves"], KINDS["a number"]):
        return 0 if words == KINDS["halves"] else 3  # halves: few mutants, whose numbers hardly any other has
    return 2 if words.startswith(("a term{} has", "a term{} lacks")) else 1


def _called(module: ModuleType, call: ComparedCall) -> Numbers:
    if call.case.points:
        return computed(module, call)
    return getattr(module, call.name)(*call.case.args, **call.case.kwargs)


def shared_mutants(text: str, name: str, other: str, calls: Sequence[Call]) -> tuple[Answer, ...]:
    """Return the answers of mutants in what two functions of a source share, which explain all calls of the first."""
    reach_of = reached(text)
    if not {name, other} <= reach_of.keys() or not reach_of[name] & reach_of[other]:
        return ()
    try:
        with limited(MOST):
            module = solution_with.__wrapped__(text, "")  # a new one, into which mutants are put
            public = {*inspect.signature(getattr(module, name)).parameters, *calls[0].case.kwargs}
            mutant = _mutant(text, module, name, _compared(text, calls), public, reach_of[name] & reach_of[other])
    except Exhausted:
        return ()
    return tuple(partial(answer, text, changed) for changed in mutant[1]) if mutant else ()


def _single_entry(solution: str, name: str, calls: Sequence[ComparedCall]) -> Cause | None:
    """Return the cause if an array is wrong in only one place or column, and the others are not only zeros."""
    pairs = [(call.result, call.expected) for call in calls]
    forms = [() if isinstance(part, tuple) else np.shape(part) for pair in pairs for part in pair]
    is_matrix, form = {len(each) for each in forms} == {2}, forms[0]
    if (
        (len({*forms}) > 1 and not is_matrix)
        or forms[::2] != forms[1::2]
        or not (len(form) in (2, 3) or (len(form) == 1 and form >= (SPACE,)))
        or calls[0].case.points
    ):
        return None
    off = [np.argwhere(np.abs(result - right) > WITHIN * np.abs(right).max()) for result, right in pairs]
    places = np.unique(np.concatenate(off), axis=0)
    if is_matrix and len(places) > 1 and not is_motion(calls[0]):
        places = np.unique(places[:, 1:], axis=0)
    if len(places) != 1 or (len(form) == 1 and not np.any([right for _, right in pairs], axis=0).all()):
        return None
    axes = AXES[len(form)][-len(places[0]) :]
    where = ", ".join(f"{axis} {index + 1}" for axis, index in zip(axes, places[0], strict=True))
    position = (slice(None),) * (len(form) - len(axes)) + tuple(places[0])
    wrong = partial(_wrong_in_place, solution, name, position)
    return Cause(name, f"Your result of {name} is wrong in {where} alone", "place", (wrong,))


def _wrong_in_place(solution: str, name: str, position: tuple[int | slice, ...], call: Call) -> Numbers:
    """Return the right answer with the student's number in one place; for other functions the right answer."""
    expected = answer(solution, "", call)
    if call.name == name and np.shape(call.result) == np.shape(expected) != ():
        expected = np.array(expected)
        expected[position] = np.asarray(call.result)[position]
    return expected


@functools.cache
def _mutants(solution: str) -> list[tuple[str, str, set[str], str, str]]:
    """Return (function, words, names in the term, missing factor, source) of each mutant that has words."""
    parameters, locals_of, documented = _unpacked(solution), _locals(solution), _documented(solution)
    return [
        (
            function,
            words,
            {
                name if name in documented else parameters.get(name, name)
                for name in _behind(
                    mutant.product if isinstance(term, ast.Constant | ast.UnaryOp) else term, locals_of[function]
                )
            },
            _missing(mutant, term, locals_of[function]),
            mutant.text,
        )
        for function, mutants in mutants_of(solution).items()
        for mutant in mutants
        for words, term in _words(mutant, parameters)
    ]


def _behind(term: ast.expr, quantities: Mapping[str, ast.expr]) -> set[str]:
    """Return the names in a term; if none is a parameter, the names from which they are computed."""
    names = seen = names_used(term)
    while names and not any(isinstance(quantities.get(name), ast.Name) for name in names):
        names = set().union(*(names_used(quantities[name]) for name in names if name in quantities)) - seen
        seen = seen | names
    return names or names_used(term)


def _documented(solution: str) -> set[str]:
    """Return the words in the docstrings that students read, except for the article "a"."""
    tree = ast.parse(solution)
    documented: list[ast.Module | ast.FunctionDef] = [tree]
    documented += [node for node in tree.body if isinstance(node, ast.FunctionDef) and node.name[0] != "_"]
    return set(re.findall(r"\w+", " ".join(ast.get_docstring(node) or "" for node in documented))) - {"a"}


def _unpacked(solution: str) -> dict[str, str]:
    """Return {part: argument} of unpacked arguments: `m1, m2 = masses`; public functions overwrite helpers."""
    functions = (node for node in ast.parse(solution).body if isinstance(node, ast.FunctionDef))
    return {
        part.id: value.id
        for function in sorted(functions, key=lambda function: function.name[0] != "_")
        for target, value in _assigned(function)
        if isinstance(value, ast.Name) and isinstance(target, ast.Tuple)
        for part in target.elts
        if isinstance(part, ast.Name)
    }


def _assigned(function: ast.FunctionDef) -> Iterator[tuple[ast.expr, ast.expr]]:
    """Yield (target, value) of each assignment; of tuples on both sides, part by part."""
    for node in ast.walk(function):
        if isinstance(node, ast.Assign) and len(node.targets) == 1:
            targets, values = (getattr(side, "elts", [side]) for side in (node.targets[0], node.value))
            is_by_parts = len(targets) == len(values)
            yield from zip(targets, values, strict=True) if is_by_parts else [(node.targets[0], node.value)]


def _locals(solution: str) -> dict[str, dict[str, ast.expr]]:
    """Return, for each function, the expressions that it assigns to names; a name that students know is its own."""
    functions = [node for node in ast.parse(solution).body if isinstance(node, ast.FunctionDef)]
    arguments = {function.name: (*function.args.args, *function.args.kwonlyargs) for function in functions}
    public = _documented(solution).union(*({side.arg for side in arguments[f]} for f in arguments if f[0] != "_"))
    public |= {part for part, source in _unpacked(solution).items() if source in public}
    assigned: dict[str, dict[str, ast.expr]] = {}
    for function in functions:
        quantities = assigned[function.name] = {
            side.arg: ast.Name(side.arg) for side in arguments[function.name] if side.arg in public
        }
        for target, value in _assigned(function):
            parts_of = [part for part in getattr(target, "elts", []) if isinstance(part, ast.Name)]
            quantities |= {part.id: ast.Name(part.id) for part in parts_of}
            quantities |= {target.id: value} if isinstance(target, ast.Name) else {}
    return assigned


def _missing(mutant: Mutant, factor: ast.expr, quantities: Mapping[str, ast.expr]) -> str:
    """Return words for a missing factor, or an ignored quantity, and the parameters beside it; "" if it is long."""
    if mutant.operator not in ("a missing factor", "ignored"):
        return ""
    words, names = _in_parameters(factor, quantities), names_used(mutant.product) - names_used(factor)
    if mutant.operator == "ignored":
        return words and f"{words} is ignored, as if it were zero"
    beside = ", ".join(sorted(name for name in names if ast.unparse(quantities.get(name, mutant.product)) == name))
    divides = isinstance(mutant.was, ast.BinOp) and isinstance(mutant.was.op, ast.Div)
    what = "division by" if divides else "factor"
    return words and f"the {what} {words} is missing{beside and f' beside {beside}'}"


def _in_parameters(term: ast.expr, quantities: Mapping[str, ast.expr]) -> str:
    """Return a factor as a student may have written it; "" if that is long, or has names that are no parameters."""

    class InParameters(ast.NodeTransformer):
        def visit_Name(self, node: ast.Name) -> ast.expr:
            value = quantities.get(node.id, node)
            return value if isinstance(value, ast.Name) or isinstance(node.ctx, ast.Store) else self.visit(value)

    try:
        text = ast.unparse(InParameters().visit(copy.deepcopy(term)))
    except RecursionError:  # the quantity is computed from itself
        return ""
    words = re.sub(r"\b(math|np|numpy)\.", "", text)
    return (
        words if len(words) <= LONGEST and set(re.findall(r"[A-Za-z_]\w*", words)) <= quantities.keys() | WORDS else ""
    )


LONGEST, WORDS = 24, {"sin", "cos", "tan", "sqrt", "exp", "pi"}


@functools.cache
def _code(text: str) -> CodeType:
    return compile_lightly(text, "<mutant>")


def _words(mutant: Mutant, parameters: Mapping[str, str]) -> Iterator[tuple[str, ast.expr]]:
    """Yield the words that a student reads of a mutant, and the term that they are about.

    parameters : {part: argument} of unpacked arguments
    """
    was, now = mutant.was, mutant.now
    if mutant.operator in WHOLE:
        yield KINDS[mutant.operator], was
    elif mutant.operator == "a multiple":
        assert isinstance(was, ast.Call) and isinstance(now, ast.BinOp)
        yield f"the result of {ast.unparse(was.func)} is multiplied by {ast.unparse(now.left)}", was
    elif mutant.operator in OF_TERMS:
        is_reversed = mutant.operator == "the sign of a component"
        yield KINDS["a sign"] if is_reversed else MISSING_TERM, _dropped(was, now)
    elif isinstance(was, ast.BinOp):
        yield from _words_of_operation(mutant, was)
    elif isinstance(now, ast.Name) and mutant.operator == "as given":
        yield f"one term uses {now.id} as it is given", now
    elif isinstance(now, ast.Name) and isinstance(was, ast.Name):
        part = f"the wrong component of {parameters[was.id]} is used" if was.id in parameters else ""
        yield part or (f"{now.id} is used for {was.id}" if was.id in LENGTHS else "the wrong quantity is used{}"), was
    elif isinstance(now, ast.Constant) and isinstance(was, ast.Constant) and mutant.operator == "an axis":
        yield f"the axis is {now.value!r} where it should be {was.value!r}", was
    elif mutant.operator == "another function" and _is_square_of_half(was, mutant.product):
        yield "a cosine{} has the wrong sign", was  # 2 sin(x/2)^2 is 1 - cos x
    elif mutant.operator in KINDS:
        yield KINDS[mutant.operator], was


def _dropped(was: ast.expr, now: ast.expr) -> ast.expr:
    """Return the missing first term of a difference, or the missing component."""
    if isinstance(was, ast.BinOp):
        return was.left
    assert isinstance(was, ast.List | ast.Tuple) and isinstance(now, ast.List | ast.Tuple)
    return next(part for part in was.elts if part not in now.elts)


def _words_of_operation(mutant: Mutant, was: ast.BinOp) -> Iterator[tuple[str, ast.expr]]:
    """Yield the words for a mutant of a sum or a product, and the term that they are about."""
    now, is_sum = mutant.now, isinstance(was.op, ast.Add | ast.Sub)
    if mutant.operator == "a missing factor":
        dropped = was.right if now is was.left else was.left
        is_two = isinstance(dropped, ast.Constant) and dropped.value in (2, 0.5)
        yield KINDS["a factor"] if is_two else MISSING_FACTOR, dropped
    elif mutant.operator == "a root":
        divisor = now.right if isinstance(now, ast.BinOp) else None
        is_square = isinstance(divisor, ast.BinOp) and ast.unparse(divisor.right) == "2"
        yield f"a divisor{{}} is {'squared' if is_square else 'its square root'}", was.right
    elif mutant.operator == "a first sign":
        yield KINDS["a sign"], was.left
    elif mutant.operator == "a factor of a term":
        assert isinstance(now, ast.BinOp)
        term, changed = (was.right, now.right) if now.left is was.left else (was.left, now.left)
        assert isinstance(changed, ast.BinOp) and isinstance(changed.right, ast.Name)
        has, many = ("has", " too many") if isinstance(changed.op, ast.Mult) else ("lacks", "")
        yield f"a term{{}} {has} a factor {changed.right.id}{many}", term
    elif mutant.operator == "half a term":
        yield KINDS[mutant.operator], was.left if was.right in ast.iter_child_nodes(now) else was.right
    elif is_sum and now is was.right and isinstance(was.op, ast.Sub):
        return  # has another sign, too
    elif is_sum and now in (was.left, was.right):
        term = was.left if now is was.right else was.right
        is_number = isinstance(term, ast.Constant) or ast.unparse(term) == "t[0]"
        yield (f"the term {ast.unparse(term).removesuffix('.0')} is missing" if is_number else MISSING_TERM, term)
    elif is_sum:
        reversed_ = isinstance(now, ast.BinOp) and now.right is was.right
        yield "the sign of a term{} is reversed" if reversed_ else "a term{} counts twice", was.right
    elif isinstance(was.op, ast.Mult | ast.Div) and mutant.operator != "an exponent":
        multiplied = isinstance(was.op, ast.Mult)
        yield f"a factor{{}} {'divides' if multiplied else 'multiplies'} where it should not", was.right
    elif isinstance(was.op, ast.MatMult):
        yield KINDS["a transpose"], was
    elif mutant.operator in KINDS:
        yield KINDS[mutant.operator], was


def _is_square_of_half(sine: ast.expr, product: ast.expr) -> bool:
    """Return whether the sine or cosine has half an angle as its argument, and is squared in the product."""
    halves = [part.value for part in ast.walk(sine) if isinstance(part, ast.Constant)]
    powers = [node.left for node in ast.walk(product) if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Pow)]
    return sine in powers and halves in ([2], [0.5])


OF_TERMS = "a missing component", "a missing first term", "the sign of a component"
WHOLE = (  # of these operators, the words are about the complete expression
    *(
        "linearised",
        "a product for a square",
        "a missing square",
        "a square of a sum",
        "two exchanged",
        "sine and cosine",
        "a tangent",
    ),
    *("a norm", "degrees", "radians", "half an angle", "the sign of an angle", "parts of a tangent", "ignored"),
    *("a frequency", "the parallel axis", "about the mass centre", "without its turning", "halves"),
)
KINDS = {
    "a sign": "the sign of a term{} is reversed",
    "an exponent": "an exponent{} is one too large or too small",
    "a factor": "a number{} is twice or half the right one",
    "a number": "a number{} is not the right one",
    **dict.fromkeys(("another function", "a tangent"), "the wrong function is used{}, such as sine for cosine"),
    **dict.fromkeys(("swapped arguments", "two exchanged"), "two quantities{} are exchanged, or their signs reversed"),
    "half a term": "a term{} counts half",
    "half an angle": "an angle is half the right one",
    **dict.fromkeys(("an index", "another index"), "the wrong component is used{}"),
    "linearised": "a sine or cosine{} is linearised, as for small angles",
    "a product for a square": "a square{} is a product of two quantities",
    "a missing square": "a quantity{} is not squared",
    "a square of a sum": "a sum{} is squared as a whole; square each of its terms",
    "a lost sign": "a sine or cosine{} has lost its sign",
    "sine and cosine": "sine and cosine{} are exchanged",
    "a root": "a square root{} is missing",
    "a frequency": "a square root{} is divided by 2 pi",
    "a norm": "a length{} is the sum of the components, not the root of the sum of their squares",
    "degrees": "an angle is in degrees; it should be in radians",
    "radians": "an angle in radians is read as degrees",
    "the sign of an angle": "an angle has the opposite sign",
    "parts of a tangent": "a number{} is twice or half the right one",
    "the parallel axis": "m l^2/4 is added to m l^2/3{}; a third is a bar's inertia about its end already",
    "about the mass centre": "m l^2/12 is used for m l^2/3{}; a third is a bar's inertia about its end",
    "without its turning": "m l^2/4 is used for m l^2/3{}; the bar's inertia m l^2/12 about its mass centre is missing",
    "halves": "every division by 2 is missing",
    "ignored": "a quantity{} is ignored, as if it were zero",
    "a transpose": "matrices{} are multiplied in the wrong order, or one is transposed",
}
