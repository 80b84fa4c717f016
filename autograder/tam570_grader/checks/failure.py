"""Record of why a check failed, from the check to the page."""

from dataclasses import dataclass

from tam570.values import Json, Numbers

WHOLE = ("expected", "actual", "at")  # fields of a failure that only the instructor sees


@dataclass(frozen=True)
class Failure:
    """Why a check failed, as data from which a page makes a sentence.

    A `quantity` has an `error`, in `unit`, beyond a `limit`, at a `time` in s; or `message` says what is wrong.
    Only the instructor sees `expected`, `actual` and `at`, the input; the student sees the rest.
    """

    quantity: str = ""
    error: float | None = None
    unit: str = ""
    limit: float | None = None
    time: float | None = None
    message: str = ""
    label: str = ""  # of the input, in words that give no input away
    hint: str = ""
    suspect: str | None = None  # the known mistake
    follows_from: str = ""  # the function with the mistake that explains this result
    near_miss: bool = False  # the error is within a loose tolerance, so that dependent checks run
    curve: Json | None = None  # the error along a motion
    sketch: Json | None = None  # a free body diagram as the student drew it
    expected: Numbers = None
    actual: Numbers = None
    at: Numbers = None
    function: str = ""  # the function called with this input
    fault: str = ""  # error of the grader in choosing the hint or the cause
