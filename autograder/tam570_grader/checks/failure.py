"""Why a check failed, as a record that travels from the check to the page."""

from dataclasses import dataclass

from tam570.values import Json, Numbers

WHOLE = ("expected", "actual", "at")  # of a failure: what the instructor alone sees


@dataclass(frozen=True)
class Failure:
    """Why a check failed, as data: a page makes a sentence of it.

    A `quantity` is wrong by `error`, in `unit`, beyond a `limit`, at a `time` in s; or `message` tells what is wrong.
    `expected`, `actual` and `at`, the very input, are the instructor's; the rest is the student's.
    """

    quantity: str = ""
    error: float | None = None
    unit: str = ""
    limit: float | None = None
    time: float | None = None
    message: str = ""
    label: str = ""  # of input, in words that give no input away
    hint: str = ""
    suspect: str | None = None  # the known mistake
    follows_from: str = ""  # the function with the mistake that explains this result
    near_miss: bool = False  # off by a loose tolerance, at most: what builds on it is judged all the same
    curve: Json | None = None  # the error along a motion
    sketch: Json | None = None  # a free body diagram as the student drew it
    expected: Numbers = None
    actual: Numbers = None
    at: Numbers = None
    function: str = ""  # that was called at this input
    fault: str = ""  # of ours, in looking for a name
