"""What goes to a submission and what comes back: arguments as sent, and replies, of which nothing is trusted."""

from typing import Any

import numpy as np

from tam570_grader.sandbox.worker import CellLost
from tam570_grader.writing.check import Given
from tam570_grader.writing.returns import Drawing, Line

__all__ = ["checked", "drawn", "error_of", "printable", "sent", "strings"]


MOST_KINDS = 20  # classes of an exception
MOST_LINES = 2000  # of a drawing: three times what is read of one


def error_of(reply: Any) -> dict[str, Any]:
    """The error of a reply, {"kinds": [], ...} where there is none, and nothing that is not of the right type."""
    error = reply.get("error") if isinstance(reply, dict) else None
    if not isinstance(error, dict) or not strings(error.get("kinds")):
        return {"kinds": [], "text": "", "line": 0}
    line, text = error.get("line"), error.get("text")
    return {
        "kinds": error["kinds"][:MOST_KINDS],
        "text": printable(" ".join(text[:300].split())) if isinstance(text, str) else "",
        "line": line if isinstance(line, int) else 0,
    }


def printable(text: str) -> str:
    """A student's words with what is no text escaped: what moves a terminal's cursor, and bytes that are not UTF-8."""
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode() for c in text)


def checked(reply: Any) -> dict[str, Any]:
    """The reply, if it has the form of one, else CellLost: it is not from our part of the process."""
    if not isinstance(reply, dict) or not ("value" in reply or "error" in reply):
        raise CellLost
    if not isinstance(reply.get("changed", False), bool):
        raise CellLost
    return reply


def strings(value: Any) -> bool:
    """Whether it is a list of strings."""
    return isinstance(value, list) and all(isinstance(item, str) for item in value)


def drawn(value: Any) -> Drawing:
    """The drawing in a reply; an exception of any class where it is none."""
    if len(value["lines"]) > MOST_LINES:
        raise ValueError("too many lines")
    lines = [
        Line(np.asarray(line["points"], float).reshape(-1, 2), str(line["label"]), bool(line["scatter"]))
        for line in value["lines"]
    ]
    return Drawing(tuple(lines), str(value["xlabel"]), str(value["ylabel"]), bool(value["equal_aspect"]))


def sent(call: Given) -> list[Any]:
    """The arguments of a call as they are sent."""
    return [[_argument(value) for value in call.args], {key: _argument(value) for key, value in call.kwargs.items()}]


def _argument(value: Any) -> Any:
    """An argument as it is sent: any sequence of numbers is a float64 array, as the contract promises."""
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, np.ndarray):
        return value.astype(float)
    if isinstance(value, list | tuple) and value:
        if all(isinstance(item, int | float | np.number) for item in value):
            return np.array(value, float)
        return [_argument(item) for item in value]
    return list(value) if isinstance(value, tuple) else value
