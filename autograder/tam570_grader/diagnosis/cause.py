"""What is wrong in a function, and what the solution answers with that mistake in its place."""

from collections.abc import Callable
from dataclasses import dataclass

from tam570.values import Numbers
from tam570_grader.checks.case import Call

Answer = Callable[[Call], Numbers]  # of the whole solution with a mistake in it, to a call of any function


@dataclass(frozen=True)
class Cause:
    """Why a check fails.

    function     : whose results are wrong
    message      : what the student reads; empty where it follows from an earlier cause
    source       : "known mistake", "result", "transform", "mutant", "place"; "rule": the check told it by the rows of a
                   motion; "own": the check found what it follows from
    answers      : what the solution gives with this mistake in it, one for each way to make it; nothing follows of none
    calls        : those that it explains
    follows_from : the function with the mistake that explains these results
    repeats      : an earlier function that was told the same
    """

    function: str
    message: str
    source: str
    answers: tuple[Answer, ...] = ()
    calls: tuple[Call, ...] = ()
    follows_from: str = ""
    repeats: str = ""
