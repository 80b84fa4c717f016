"""What did the student do? A mistake is named once; what follows from it is not accused."""

from collections.abc import Iterable, Sequence
from dataclasses import replace
from itertools import product
from pathlib import Path

from tam570_grader.diagnosis.cause import Called, Cause
from tam570_grader.diagnosis.mistakes import candidates, explains, known
from tam570_grader.diagnosis.search import general, wrong_arguments

__all__ = ["diagnose", "follows"]


def diagnose(solution: str, folder: Path, calls: Sequence[Called], earlier: Sequence[Cause] = ()) -> Cause | None:
    """Why a check fails.

    Parameters
    ----------
    solution : the text of the reference solution
    folder : the assignment's checks
    calls : those that the failed check made, with the student's results
    earlier : the causes of the checks that failed before it

    Returns
    -------
    What follows from an earlier cause; else a known mistake, a transform of arguments or results, or a mutant of the
    solution, of which one alone explains all calls; None if nothing does.
    """
    if found := follows(solution, calls, earlier):
        return found
    suspects = candidates(solution, folder, {call.name for call in calls})
    found = known(solution, suspects, calls) or general(solution, calls)
    if found and earlier:
        common = _in_common(solution, [found, *wrong_arguments(solution, calls)], earlier)
        alike = [one.function for one in earlier if _of(found, "it") == _of(one, "it")]
        return common or (replace(found, message=f"{found.message}, as in {alike[0]}") if alike else found)
    return found


def _of(cause: Cause, name: str) -> str:
    """What is said of a cause, of a function of another name."""
    return cause.message.replace(cause.function, name) if cause.kind != "known mistake" else cause.function


def follows(solution: str, calls: Sequence[Called], earlier: Iterable[Cause]) -> Cause | None:
    """The cause of calls whose results are all the solution's with an earlier mistake in it; None if there is none."""
    for cause in earlier:
        if any(explains(solution, answer, calls) for answer in cause.answers):
            (wrong, *_) = *_others(cause.function, calls), cause.function
            return Cause(wrong, "", cause.kind, follows_from=cause.function)  # nothing new follows from it
    return None


def _in_common(solution: str, causes: Iterable[Cause], earlier: Sequence[Cause]) -> Cause | None:
    """The cause that was made in an earlier function, too: these results follow from it."""
    for found, before in product(causes, earlier):
        same = tuple(answer for answer in found.answers if explains(solution, answer, before.calls))
        if same and _others(before.function, found.calls):
            return replace(found, message="", answers=same, follows_from=before.function)
    return None


def _others(function: str, calls: Sequence[Called]) -> list[str]:
    """The functions that are called besides one."""
    return [call.name for call in calls if call.name != function]
