"""Where a failure becomes a sentence: the quantity, the error with its unit, the limit, the time, the kind of input."""

import re
from math import isfinite

from tam570_grader.writing.failures import Failure

__all__ = ["known_mistake", "message", "quantity", "typeset", "whole"]

DIGITS = range(2, 17)  # of a number: two, or as many as tell an error from its limit

# a number with an exponent, as a terminal has it; in rtol=1e-9 it is code
EXPONENT = re.compile(r"(?<![\w.=])(\d+(?:\.\d+)?)e([-+]?)0*(\d+)\b")
RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def message(failure: Failure) -> str:
    """What a student reads of a failure, without the known mistake; where there is one, no hint, which is a guess."""
    says = failure.says or _off(failure)
    where = f" at t = {failure.time:g} s" if failure.time is not None else ""
    kind = f" for {failure.kind}" if failure.kind else ""
    told = re.sub("^(an?|the) ", lambda found: found[0].capitalize(), f"{says}{where}{kind}")
    return " ".join(filter(None, [_sentence(told), "" if failure.suspect else _sentence(failure.hint)]))


def whole(failure: Failure) -> str:
    """What a student reads of a failure where there is one line for all of it."""
    return " ".join(filter(None, [message(failure), known_mistake(failure.suspect) if failure.suspect else ""]))


def known_mistake(suspect: str) -> str:
    """What a student reads of a known mistake."""
    return f"Your numbers match this mistake: {_sentence(suspect)}"


def quantity(value: float, digits: int = DIGITS[0]) -> str:
    """A number to two digits or more, as people write it: 2.7, 0.031, 340, 1.1e-13."""
    if not isfinite(value):
        return "more than any number"
    short = float(f"{value:.{digits}g}")
    if value == 0 or 1e-3 <= abs(short) < 1e4:
        return f"{short:.{max(digits, 4)}g}"
    number, _, exponent = f"{value:.{digits - 1}e}".partition("e")
    return f"{float(number):.{digits}g}e{int(exponent)}"


def typeset(text: str) -> str:
    """The text with its numbers as a page has them: 1.1·10⁻¹³ for 1.1e-13, and 10⁻⁴ for 1e-4."""
    return EXPONENT.sub(_typeset, text)


def _typeset(found: re.Match[str]) -> str:
    factor = "" if found[1] == "1" else f"{found[1]}·"
    return f"{factor}10{f'{found[2]}{found[3]}'.replace('+', '').translate(RAISED)}"


def _off(failure: Failure) -> str:
    error, limit = (float("nan") if one is None else one for one in (failure.error, failure.limit))
    unit = f" {failure.unit}" if failure.unit else ""
    pairs = ([quantity(one, digits) for one in (error, limit)] for digits in DIGITS)
    shown, allowed = next((pair for pair in pairs if pair[0] != pair[1]), (quantity(error), quantity(limit)))
    return f"{failure.of} is wrong by {shown}{unit}" + (f" (limit {allowed})" if isfinite(limit) else "")


def _sentence(text: str) -> str:
    """The text with a stop; who wrote it has chosen between a capital and a name that keeps its letters."""
    text = text.strip()
    return text if not text or text[-1] in ".?!" else text + "."
