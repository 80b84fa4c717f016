"""Where a failure becomes a sentence: the quantity, the error with its unit, the limit, the time, the kind of input."""

import re
from math import isfinite

from tam570_grader.results.records import Failure

__all__ = ["known_mistake", "message", "quantity", "typeset", "whole"]

# words that open a sentence; what else stands there may be code
OPENING = re.compile(
    r"(an?|all|and|angles?|are|at|both|by|did|do|does|each|every|for|from|how|if|in|is|it|nearly|no|not|nothing|one|only|over|rows?"
    r"|results?|some|take|the|there|these|they|this|use|what|where|which|with|without|work|your?)\b"
)


# a number with an exponent, as a terminal has it; in rtol=1e-9 it is code
EXPONENT = re.compile(r"(?<![\w.=])(\d+(?:\.\d+)?)e([-+]?)0*(\d+)\b")
RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def message(failure: Failure) -> str:
    """What a student reads of a failure, without the known mistake."""
    says = failure.says or _off(failure)
    where = f" at t = {failure.time:g} s" if failure.time is not None else ""
    kind = f" for {failure.kind}" if failure.kind else ""
    return " ".join(filter(None, [_sentence(f"{says}{where}{kind}"), _sentence(failure.hint)]))


def whole(failure: Failure) -> str:
    """What a student reads of a failure where there is one line for all of it."""
    return " ".join(filter(None, [message(failure), known_mistake(failure.suspect) if failure.suspect else ""]))


def known_mistake(suspect: str) -> str:
    """What a student reads of a known mistake."""
    return f"Your numbers match this mistake: {_sentence(suspect)}"


def quantity(value: float) -> str:
    """A number to two digits, as people write it: 2.7, 0.031, 1.1e-13."""
    if not isfinite(value):
        return "more than any number"
    return (
        f"{value:.2g}"
        if value == 0 or 1e-3 <= abs(value) < 1e4
        else f"{value:.1e}".replace("e-0", "e-").replace("e+0", "e")
    )


def typeset(text: str) -> str:
    """The text with its numbers as a page has them: 1.1·10⁻¹³ for 1.1e-13, and 10⁻⁴ for 1e-4."""
    return EXPONENT.sub(_typeset, text)


def _typeset(found: re.Match[str]) -> str:
    factor = "" if found[1] == "1" else f"{found[1]}·"
    return f"{factor}10{f'{found[2]}{found[3]}'.replace('+', '').translate(RAISED)}"


def _off(failure: Failure) -> str:
    error = failure.error if failure.error is not None else float("nan")
    unit = f" {failure.unit}" if failure.unit else ""
    limit = f" (limit {_limit(failure.limit)})" if failure.limit is not None else ""
    return f"{failure.of} is wrong by {quantity(error)}{unit}{limit}"


def _limit(limit: float) -> str:
    return f"{limit:.2g}" if 1e-3 <= limit < 1e4 else _short(f"{limit:.1g}")


def _short(number: str) -> str:
    """1.1e-9 for 1.1e-09."""
    return number.replace("e-0", "e-").replace("e+0", "e").replace("e+", "e")


def _sentence(text: str) -> str:
    """The text with a capital and a stop; the name of a function keeps its letters."""
    text = text.strip()
    if not text:
        return ""
    text = text[0].upper() + text[1:] if OPENING.match(text) else text
    return text if text[-1] in ".?!" else text + "."
