"""Diagnose failed checks: name each mistake once, and do not charge what follows from it."""

import functools
from collections.abc import Iterable, Sequence, Set
from dataclasses import replace
from itertools import product
from pathlib import Path

from tam570_grader.checks.assignments import other_functions
from tam570_grader.checks.case import Call
from tam570_grader.diagnosis.cause import Cause
from tam570_grader.diagnosis.mistakes import (
    candidates,
    explains,
    is_motion,
    named_mistake,
    right_answer,
    same,
    tolerance_of,
)
from tam570_grader.diagnosis.mutants import OTHER_FUNCTION, SINE_AND_COSINE
from tam570_grader.diagnosis.search import general, wrong_arguments


def diagnose(  # noqa: PLR0913  what is known of a failed check
    solution: str,
    folder: Path,
    calls: Sequence[Call],
    earlier: Sequence[Cause] = (),
    *,
    may_follow: bool = True,
    is_told: bool = False,
    passed: Set[str] = frozenset(),
) -> Cause | None:
    """Return why a check fails, if its results do not all follow from an earlier cause.

    Parameters
    ----------
    solution : source of the reference solution
    folder : folder of the assignment's checks
    calls : the calls of the failed check, with the student's results
    earlier : the causes of the checks that failed before it
    may_follow : whether the mistake may be that of one of these
    is_told : whether the check says what is wrong, so that only a known mistake says more
    passed : other functions, which passed their checks: known mistakes in these are ruled out, mutants tried last

    Returns
    -------
    A known mistake, a transform of arguments or results, or a mutant of the
    solution, if it is the only one that explains all calls; else None.
    """
    calls = [call for call in calls if call.result is None or right_answer(solution, call) is not None]  # not refused
    suspects = candidates(solution, folder, {call.name for call in calls})
    suspects = [suspect for suspect in suspects if not suspect.defined & passed]
    cause = named_mistake(solution, suspects, calls)
    if cause is None and not is_told:
        cause = general(solution, calls, other_functions(folder), passed)
    if cause is None or not earlier:
        return cause
    before = [call for other in earlier for call in other.calls]
    causes = [cause, *wrong_arguments(solution, calls, before)] if may_follow else []
    return _in_common(solution, causes, earlier) or _as_in(cause, earlier, may_follow=may_follow)


def _as_in(cause: Cause, earlier: Sequence[Cause], *, may_follow: bool) -> Cause:
    """Return the cause, related to an earlier function with the same message: as one slip, if it may follow."""
    others = [(other.function, _told(other)) for other in earlier if other.source == cause.source and other.message]
    messages = {name: (_told(cause), _told(cause).replace(cause.function, name)) for name, _ in others}
    same = next((name for name, message in others if name != cause.function and message in messages[name]), "")
    if same and may_follow and cause.source != "result":
        return replace(cause, message="", follows_from=same)
    is_as_in = same and cause.source != "known mistake"
    return replace(cause, message=f"{cause.message}, as in {same}", repeats=same) if is_as_in else cause


def _told(cause: Cause) -> str:
    """Return the message; instead of one of sine and cosine wrong, both exchanged, as in a function that has both."""
    single, both = OTHER_FUNCTION.split("{}"), SINE_AND_COSINE.split("{}")
    return functools.reduce(lambda text, words: text.replace(*words), zip(single, both, strict=True), cause.message)


def follows(solution: str, calls: Sequence[Call], earlier: Iterable[Cause]) -> Cause | None:
    """Return the cause of calls whose results are all those of the solution with an earlier mistake; else None."""
    for cause in earlier:
        if any(explains(solution, answer, calls) for answer in cause.answers):
            wrong = next((call.name for call in calls if call.name != cause.function), cause.function)
            return Cause(wrong, "", cause.source, follows_from=cause.function)  # no answers: nothing follows from it
    return None


def is_refuted(cause: Cause, passing: Iterable[Call]) -> bool:
    """Return whether most right results of the cause's function would be wrong because of it."""
    its_calls = (call for call in passing if call.name == cause.function and call.result is not None)
    calls = [call for call in its_calls if not is_motion(call)]
    agreeing = [any(same(call.result, answer(call), tolerance_of(call)) for answer in cause.answers) for call in calls]
    return bool(cause.answers) and 2 * sum(agreeing) < len(calls)


def _in_common(solution: str, causes: Iterable[Cause], earlier: Sequence[Cause]) -> Cause | None:
    """Return the cause if an earlier function has the same mistake, from which these results follow; else None."""
    for cause, before in product(causes, earlier):
        if same := tuple(answer for answer in cause.answers if explains(solution, answer, before.calls)):
            return replace(cause, message="", answers=same, follows_from=before.function)
    return None
