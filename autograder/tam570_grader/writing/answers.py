"""What is right at an input, computed a single time for a class that is given the same inputs."""

from collections.abc import Callable
from typing import Any

from tam570_grader.sandbox.inside.wire import packed
from tam570_grader.writing.check import Given, Memory

__all__ = ["answer"]

MOST_KNOWN = 3000  # answers; with inputs of its own for each student a run makes thousands

_known = Memory(MOST_KNOWN)


def answer(right: Callable[..., Any], case: Given) -> Any:
    """right(*args, **kwargs) of a case; it is shared, and not to be changed."""
    from tam570_grader.sandbox.replies import sent

    return _known.value((right, packed(sent(case))), lambda: right(*case.args, **case.kwargs))
