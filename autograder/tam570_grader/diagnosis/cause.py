"""The cause of a failed check, with the solution's answers if it has this mistake."""

from collections.abc import Callable
from dataclasses import dataclass

from tam570.values import Numbers
from tam570_grader.checks.case import Call

Answer = Callable[[Call], Numbers]  # answer(call), to a call of any function, of the solution with a mistake in it


@dataclass(frozen=True)
class Cause:
    """Why a check fails.

    function     : the function whose results are wrong
    message      : what the student reads; empty if the failure follows from an earlier cause
    source       : "known mistake", "result", "transform", "mutant", "place"; "rule": the check sees it in the rows of a
                   motion; "memory": the call is right in a new process; "own": calls of the student's own functions
                   show from which one it follows
    answers      : the solution's answers with this mistake in it, for each way to make it; nothing follows if empty
    calls        : the calls that it explains
    follows_from : the function with the mistake that explains these results
    repeats      : an earlier function with the same message
    """

    function: str
    message: str
    source: str
    answers: tuple[Answer, ...] = ()
    calls: tuple[Call, ...] = ()
    follows_from: str = ""
    repeats: str = ""
