"""Turn a failure into a sentence: quantity, error with unit, limit, time, and label of the input."""

import re
from decimal import ROUND_HALF_UP, Decimal
from math import inf, isfinite

from tam570_grader.checks.failure import Failure

DIGITS = range(2, 17)  # significant digits of a number: two, or as many as distinguish an error from its limit

EQUAL = 1e-9  # points; equal sums in another order differ by less

# a number with an exponent, but not in code such as rtol=1e-9
EXPONENT = re.compile(r"(?<![\w.=])(\d+(?:\.\d+)?)e([-+]?)0*(\d+)\b")
RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def describe_failure(failure: Failure) -> str:
    """Return the sentences on a failure for the student; a known mistake replaces the hint, which is a guess."""
    if not failure.follows_from:
        hint = failure.hint
    elif failure.follows_from == failure.function:
        hint = "You make the same mistake as before"
    else:
        hint = f"Your {failure.function} uses or repeats the mistake in {failure.follows_from}"
    message = failure.message or _off(failure)
    where = f" at t = {failure.time:g} s" if failure.time is not None else ""
    label = f" for {failure.label}" if failure.label else ""
    text = capitalized(f"{message}{where}{label}", "an?|the")
    return " ".join(filter(None, [sentence(text), "" if failure.suspect else sentence(hint)]))


def full_message(failure: Failure) -> str:
    """Return all sentences on a failure for the student, including the known mistake."""
    suspect = [known_mistake(failure.suspect)] if failure.suspect else []
    return " ".join([describe_failure(failure), *suspect])


def known_mistake(mistake: str) -> str:
    """Return the sentence on a known mistake for the student."""
    return f"Your numbers match this mistake: {sentence(mistake)}"


def quantity(value: float, digits: int = DIGITS[0]) -> str:
    """Return a number with two or more significant digits, as people write it: 2.7, 0.031, 340, 1.1e-13."""
    if not isfinite(value):
        return "more than any number"
    short = float(f"{value:.{digits}g}")
    if value == 0 or 1e-3 <= abs(short) < 1e4:
        return f"{short:.{max(digits, 4)}g}"
    number, _, exponent = f"{value:.{digits - 1}e}".partition("e")
    return f"{float(number):.{digits}g}e{int(exponent)}"


def points(earned: float | None, most: float = inf) -> str:
    """Return points with at most two decimals; fewer points than `most` are never rounded up to `most`."""
    if earned is None:
        return "?"
    shown = _hundredths(earned)
    return f"{(min(shown, _hundredths(most) - 1) if earned < most - EQUAL else shown) / 100:g}"


def _hundredths(number: float) -> float:
    return float(Decimal(repr(number)).scaleb(2).to_integral_value(ROUND_HALF_UP))


def typeset(text: str) -> str:
    """Return the text with typeset powers of ten: 1.1·10⁻¹³ for 1.1e-13, and 10⁻⁴ for 1e-4."""
    return EXPONENT.sub(_typeset, text)


def _typeset(match: re.Match[str]) -> str:
    factor = "" if match[1] == "1" else f"{match[1]}·"
    return f"{factor}10{f'{match[2]}{match[3]}'.replace('+', '').translate(RAISED)}"


def _off(failure: Failure) -> str:
    error, limit = (float("nan") if value is None else value for value in (failure.error, failure.limit))
    unit = f" {failure.unit}" if failure.unit else ""
    pairs = ([quantity(value, digits) for value in (error, limit)] for digits in DIGITS)
    shown, allowed = next((pair for pair in pairs if pair[0] != pair[1]), (quantity(error), quantity(limit)))
    return f"{failure.quantity} is wrong by {shown}{unit}" + (f" (limit {allowed})" if isfinite(limit) else "")


def capitalized(text: str, words: str = "[a-z]+") -> str:
    """Return the text, capitalized if it begins with a word that matches `words`; names of files stay as they are."""
    return re.sub(f"^({words}) ", lambda match: match[0].capitalize(), text)


def sentence(text: str) -> str:
    """Return the text with a full stop at its end; it is not capitalized, as it may begin with a name."""
    text = text.strip()
    return text if not text or text[-1] in ".?!" else text + "."
