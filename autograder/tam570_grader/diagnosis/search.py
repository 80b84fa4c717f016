"""Search for mistakes that nobody has written down: a sign, a factor, a swapped pair, degrees, a missing term.

If no known mistake gives the student's numbers, two families of variants are tried on the same inputs. The first
changes the arguments or the result of the right function; the second makes one slip in the solution's own code. A
variant is named if it is the only one that explains every call of the check, of which at least two are wrong.
"""

import functools
import inspect
import warnings
from collections.abc import Callable, Iterable, Iterator, Sequence, Set
from dataclasses import dataclass, replace
from functools import partial
from itertools import groupby
from types import CodeType, ModuleType

import numpy as np

from tam570.checking.transforms import (
    AXES,
    SPACE,
    WITHOUT_SIGN,
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
from tam570_grader.diagnosis.mistakes import (
    CANCELLED,
    WITHIN,
    answer,
    computed,
    is_motion,
    largest,
    right_answer,
    same,
    solution_with,
)
from tam570_grader.diagnosis.mutants import EVERY_HALF, MISSING_FACTOR, MISSING_TERM, reached
from tam570_grader.diagnosis.terms import NamedMutant, named_mutants

FEWEST = 2  # wrong answers: a single one may agree by chance
MOST = 1_000_000  # steps of all variants, about a second; mistakes that are named take a third of them
OF_ONE = 100_000  # steps of one variant in one call: a mutant may loop forever
VAGUE = "counts twice", "counts half"  # ends of messages; a mutant may say more: a missing number, or one too many
REVERSED = "has the opposite sign"
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
            compared = _compared(solution, calls)
            compared += filter(None, map(beginning, compared))
            # First the calls that rule out most variants, at the least cost.
            compared.sort(key=lambda call: (call.fits(call.expected), len(call.case.packed)))
            names = {call.name for call in compared if not call.fits(call.expected)}
            if len(names) != 1:
                return None
            (name,) = names
            cause = _general(Search(solution, others, passed, name, getattr(_module(solution), name), compared))
            return replace(cause, calls=tuple(calls)) if cause and cause.answers else cause
    except Exhausted:
        return None


@dataclass(frozen=True)
class Search:
    """A function with wrong results, and the calls that a variant of the right one must explain.

    solution  : source of the reference solution
    others    : sources of other right functions, in place of the solution's own
    passed    : functions of the student that passed
    name      : the only function with wrong results
    reference : the right function
    calls     : the calls beside the right answers; wrong ones first
    """

    solution: str
    others: Sequence[str]
    passed: Set[str]
    name: str
    reference: Function
    calls: Sequence[ComparedCall]

    @functools.cached_property
    def its_calls(self) -> list[ComparedCall]:
        """The calls of the function; its first one is wrong."""
        return [call for call in self.calls if call.name == self.name]

    @functools.cached_property
    def wrong(self) -> list[ComparedCall]:
        """The calls with wrong results."""
        return [call for call in self.its_calls if not call.fits(call.expected)]


def _compared(solution: str, calls: Sequence[Call]) -> list[ComparedCall]:
    """Return the calls beside the right answers; an empty list if one failed, or has no right answer."""
    if any(call.result is None for call in calls):
        return []
    expected, sizes = [right_answer(solution, call) for call in calls], dict[str, float]()
    for call in calls:
        sizes[call.name] = max(1.0, sizes.get(call.name, 0.0), largest(call.result))
    compared = [compared_call(call, value, sizes[call.name]) for call, value in zip(calls, expected, strict=True)]
    return [] if any(value is None for value in expected) else compared


def _general(search: Search) -> Cause | None:
    name = search.name
    if not any(np.any(part) for call in search.its_calls for part in parts(call.result)):
        return Cause(name, f"Your result of {name} is zero", "result")
    if _are_alike(search.its_calls):
        return Cause(name, f"Your result of {name} is the same for all inputs", "result")
    if len(set().union(*(call.numbers() for call in search.wrong))) < FEWEST:
        return _without_sign(search)
    cause = _other_result(search) or _other_symbol(search) or _other_argument(search)
    if cause is None or cause.message.endswith(VAGUE):
        mutant = _mutant_of_any(search)
        cause = mutant if mutant and not (cause and mutant.message.endswith(EVERY_HALF)) else cause
    cause = cause or _for_one_word(search)
    if cause is None:  # any other change of an argument or a result, or the only place where the result is wrong
        forms = other_forms(name, search.reference, search.its_calls[0])
        change = _either_reversed(search) or next(_explaining(forms, search.its_calls), None)
        cause = _transformed(search, change) or _single_entry(search) or _for_one_sign(search)
    return cause


def _are_alike(calls: Sequence[ComparedCall]) -> bool:
    """Return whether the results of several calls are the same, although the right ones differ."""
    first, *others = calls
    return len(others) >= FEWEST and (
        all(same(call.result, first.result, CANCELLED) for call in others)
        and not any(same(call.expected, first.expected, WITHIN) for call in others)
    )


def _other_result(search: Search) -> Cause | None:
    """Return the cause for the first wrong result that explains the calls."""
    first, parameters = search.wrong[0], {str(call.case.kwargs) for call in search.wrong}
    vary = len(parameters) >= FEWEST or not first.case.kwargs
    results = other_results(search.name, search.reference, first, vary=vary)
    return _transformed(search, next(_explaining(results, search.its_calls), None), source="result")


def _without_sign(search: Search) -> Cause | None:
    """Return the cause if a single wrong result is the absolute value of the right one, as are several right ones."""
    right = [call.numbers() for call in search.its_calls if call.fits(call.expected)]
    if len(set().union(*right)) < FEWEST:
        return None
    results = other_results(search.name, search.reference, search.wrong[0], vary=False)
    signs = [(words, change) for words, change in results if words.endswith(WITHOUT_SIGN)]
    return _transformed(search, next(_explaining(signs, search.its_calls), None), source="result")


def _other_argument(search: Search) -> Cause | None:
    """Return the cause for a wrong argument, factor, product or word, if no other of its family explains the calls."""
    name, reference, calls = search.name, search.reference, search.its_calls
    families = (
        other_arguments(name, reference, calls[0]),
        other_factors(name, reference, calls[0]),
        other_products(name, reference, calls[0]),
        other_words(name, reference, [call.case for call in calls]),
    )
    explaining = ([*_explaining(family, calls)] for family in families)
    return _transformed(search, next((variants[0] for variants in explaining if len(variants) == 1), None))


def _transformed(search: Search, change: tuple[str, Transform] | None, source: str = "transform") -> Cause | None:
    """Return the cause for a variant; None for None."""
    if change is None:
        return None
    words, transform = change
    return Cause(search.name, words, source, _with_variant(search.solution, search.name, transform))


def _other_symbol(search: Search) -> Cause | None:
    """Return the cause for the only wrong symbol of a formula that explains all calls."""
    calls = search.its_calls
    changes = other_symbols(search.name, calls[0].case.args[0]) if calls[0].case.points else ()
    variants = ((words, partial(_at_other_points, search.solution, change)) for words, change in changes)
    explaining = {words: change for words, change in variants if _explains(change, calls)}
    if len(explaining) != 1:
        return None
    ((words, change),) = explaining.items()
    return Cause(search.name, words, "transform", (change,))


def _at_other_points(solution: str, change: Callable[[Numbers], Numbers], call: Call) -> Numbers:
    """Return the value of the solution's formula with other values of its symbols; None for other functions."""
    if not call.case.points:
        return None
    points = Case(change(call.case.args[0]))
    return computed(solution_with(solution, ""), ComparedCall(call.name, points, None, None))


def _either_reversed(search: Search) -> tuple[str, Transform] | None:
    """Return an argument of the wrong sign, with words for all arguments whose wrong sign gives the same numbers."""
    arguments = other_arguments(search.name, search.reference, search.its_calls[0])
    explaining = [*_explaining(arguments, search.its_calls)]
    if not explaining or not all(words.endswith(REVERSED) for words, _ in explaining):
        return None
    (words, transform), *others = explaining
    return ", or ".join([words, *(other.removeprefix(f"In {search.name}, ") for other, _ in others)]), transform


def _explaining(
    family: Iterable[tuple[str, Transform]], calls: Sequence[ComparedCall]
) -> Iterator[tuple[str, Transform]]:
    """Yield the variants of a family that explain all calls."""
    return ((words, transform) for words, transform in family if _explains(transform, calls))


def _for_one_word(search: Search) -> Cause | None:
    """Return the cause of answers that are wrong only if an argument is one certain word."""
    of_all = set.intersection(*(set(_words(call)) for call in search.wrong))
    word = next((word for word in _words(search.wrong[0]) if word in of_all), None)
    there = [call for call in search.its_calls if word in _words(call)]
    if not word or len(there) == len(search.its_calls):
        return None
    at_word = replace(search, calls=there)
    cause = _other_result(at_word) or _other_argument(at_word) or _mutant_of_any(at_word)
    position, value = word
    key = [*inspect.signature(search.reference).parameters][position]

    def there_alone(wrong: Answer, call: Call) -> Numbers:
        return wrong(call) if value in map(str, call.case.args) else answer(search.solution, "", call)

    answers = tuple(partial(there_alone, wrong) for wrong in cause.answers) if cause else ()
    return cause and replace(cause, message=f"{cause.message} where {key} is {value!r}", answers=answers)


def _words(call: Call) -> list[tuple[int, str]]:
    """Return the position and the value of each argument that is a word."""
    return [(position, value) for position, value in enumerate(call.case.args) if isinstance(value, str)]


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


def _mutant_of_any(search: Search) -> Cause | None:
    """Return the cause for mutants of the solution, or of it with other functions, that explain all calls."""
    public = set(inspect.signature(search.reference).parameters)
    for other in ("", *search.others):
        source, module = other or search.solution, _module(search.solution, other)
        reach_of = reached(source)
        reach = reach_of.get(search.name, set())
        likely = reach.difference(*(reach_of.get(function, ()) for function in search.passed))
        for suspects in filter(None, (likely, reach - likely)):  # a student's copy of a passed helper may be wrong
            if mutant := _mutant(_mutants(source, suspects), module, search.name, search.calls, public, set()):
                words, texts = mutant
                answers = tuple(partial(answer, search.solution, f"{other}\n{text}") for text in texts)
                return Cause(search.name, words, "mutant", answers)
    return None


def _module(*texts: str) -> ModuleType:
    """Return a new module with these definitions, into which mutants are put."""
    module = ModuleType("_varied")
    for text in texts:
        exec(_code(text), vars(module))
    return module


def _mutants(source: str, suspects: Set[str]) -> list[NamedMutant]:
    """Return the mutants of the functions of the source that may have the slip."""
    return [mutant for mutant in named_mutants(source) if mutant.function in suspects]


def _mutant(
    mutants: Sequence[NamedMutant],
    module: ModuleType,
    name: str,
    calls: Sequence[ComparedCall],
    public: Set[str],
    refuted: set[str],
) -> tuple[str, list[str]] | None:
    """Return the words and sources of the mutants that explain all calls, if all have the same words; else None.

    public : the parameters of the function
    refuted : see `shared_mutants`
    """
    by_rank = (list(group) for _, group in groupby(mutants, key=lambda mutant: mutant.edit.rank))
    explaining = next(
        filter(None, (_explaining_mutants(group, module, calls, public, refuted) for group in by_rank)), {}
    )
    edits = {mutant.edit for mutant in explaining.values()}
    words = {edit.words for edit in edits}
    if MISSING_FACTOR in words:
        words.discard(MISSING_TERM)  # without the term, the factor is 1
    for gives_way in (1, 2, 3):
        if len(words) > 1:
            words -= {edit.words for edit in edits if edit.gives_way == gives_way}
    if len(words) != 1:
        return None
    by_term = {term: mutant for (_, term), mutant in explaining.items() if mutant.edit.words in words}
    texts, exact = [mutant.text for mutant in by_term.values()], {mutant.exact for mutant in by_term.values()}
    if len(exact) == 1 and "" not in exact:
        return f"In {name}, {exact.pop()}", texts
    term = ", ".join(sorted(set.intersection(*(set(term.split(", ")) for term in by_term))))
    term = term or (" or ".join(sorted(by_term)) if len(by_term) == 2 and all(by_term) else "")
    return f"In {name}, {words.pop().format(f' with {term}' if term else '')}", texts


def _explaining_mutants(
    mutants: Iterable[NamedMutant],
    module: ModuleType,
    calls: Sequence[ComparedCall],
    public: Set[str],
    refuted: set[str],
) -> dict[tuple[str, str], NamedMutant]:
    """Return the first mutant with each words and term that explains all calls."""
    explaining: dict[tuple[str, str], NamedMutant] = {}
    for mutant in mutants:
        key = mutant.edit.words, mutant.term(public)
        if key not in explaining and mutant.text not in refuted:
            right = getattr(module, mutant.function)
            exec(_code(mutant.text), vars(module))
            if _explains(partial(_called, module), calls):
                explaining[key] = mutant
            else:
                refuted.add(mutant.text)
            setattr(module, mutant.function, right)
    return explaining


def _called(module: ModuleType, call: ComparedCall) -> Numbers:
    if call.case.points:
        return computed(module, call)
    return getattr(module, call.name)(*call.case.args, **call.case.kwargs)


def shared_mutants(text: str, name: str, other: str, calls: Sequence[Call], refuted: set[str]) -> tuple[Answer, ...]:
    """Return the answers of mutants in what two functions of a source share, which explain all calls of the first.

    refuted : the sources of mutants that do not explain these calls, for the next search; updated
    """
    reach_of = reached(text)
    if not {name, other} <= reach_of.keys() or not reach_of[name] & reach_of[other]:
        return ()
    try:
        with limited(MOST):
            module = solution_with.__wrapped__(text, "")  # a new one, into which mutants are put
            public = {*inspect.signature(getattr(module, name)).parameters, *calls[0].case.kwargs}
            mutants = _mutants(text, reach_of[name] & reach_of[other])
            mutant = _mutant(mutants, module, name, _compared(text, calls), public, refuted)
    except Exhausted:
        return ()
    return tuple(partial(answer, text, changed) for changed in mutant[1]) if mutant else ()


def _single_entry(search: Search) -> Cause | None:
    """Return the cause if an array is wrong in only one place or column, and the others are not only zeros."""
    name, calls = search.name, search.its_calls
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
    wrong = partial(_wrong_in_place, search.solution, name, position)
    return Cause(name, f"Your result of {name} is wrong in {where} alone", "place", (wrong,))


def _for_one_sign(search: Search) -> Cause | None:
    """Return the cause if results are wrong exactly where one argument is negative."""
    signature, calls = inspect.signature(search.reference), search.its_calls
    if calls[0].case.points:
        return None
    arguments = [signature.bind(*call.case.args, **call.case.kwargs).arguments for call in calls]
    are_wrong = [not call.fits(call.expected) for call in calls]
    negative = {
        name: [isinstance(values[name], int | float) and values[name] < 0 for values in arguments]
        for name in arguments[0]
    }
    names = [name for name, where in negative.items() if where == are_wrong]
    if len(names) != 1 or are_wrong.count(False) < FEWEST:
        return None
    return Cause(search.name, f"Your result of {search.name} is wrong only where {names[0]} is negative", "place")


def _wrong_in_place(solution: str, name: str, position: tuple[int | slice, ...], call: Call) -> Numbers:
    """Return the right answer with the student's number in one place; for other functions the right answer."""
    expected = answer(solution, "", call)
    if call.name == name and np.shape(call.result) == np.shape(expected) != ():
        expected = np.array(expected)
        expected[position] = np.asarray(call.result)[position]
    return expected


@functools.cache
def _code(text: str) -> CodeType:
    return compile_lightly(text, "<mutant>")
