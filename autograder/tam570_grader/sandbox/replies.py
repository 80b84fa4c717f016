"""Check the replies of a submission, which are untrusted.

    reply    {"value": ..., "changed": bool} or {"error": {"kinds": [...], "text": ..., "line": ...}}
    message  {"replies": [reply, ...]}, or {"values": array} for calls without errors and with results of one form

A student's process can send any bytes. Before other code uses a reply, its types, depth, size and number are checked
against those of its mode: numbers for a call, values for a formula, lines and labels for a drawing.
"""

import math
from typing import Any

import numpy as np

from tam570.formulas import REMEDIES
from tam570.values import Json, Numbers
from tam570_grader.checks.returns import Drawing, Line
from tam570_grader.errors import printable
from tam570_grader.protocol.wire import DEEPEST, LONGEST_TEXT, MOST_DIMENSIONS, Foreign
from tam570_grader.sandbox.process import ProcessLost

Reply = Json

MOST_KINDS = 20  # classes of an exception
MOST_LINES = 2000  # of a drawing; `protocol.picture` reads up to 500 lines, collections and patches each
MOST_POINTS = 2**20  # of all lines of a drawing
MOST_SCATTERED = 10_000  # points of a scatter plot; more are thinned, as checks search a path for each
MOST_EMPTY = 10_000  # lists in an array without numbers, whose shape costs no memory
MOST_WORDS = 100  # unknown symbols of a formula, functions of a module, cells of a notebook
NO_ERROR: Reply = {"kinds": [], "text": "", "line": 0}


def checked(message: object, mode: str, most: int = 1) -> list[Reply]:
    """Return the replies in a message, at most `most`, each reduced to what its mode allows.

    Raise ProcessLost if the message is invalid, and so not from our code in the process.
    """
    replies = message.get("replies") if isinstance(message, dict) else None
    if isinstance(replies, list) and 0 < len(replies) <= most:
        return [_reply(reply, mode) for reply in replies]
    values = message.get("values") if isinstance(message, dict) else None
    if not isinstance(values, np.ndarray) or not values.ndim or not 0 < len(values) <= most:
        raise ProcessLost
    return [{"value": FORMS[mode](row), "changed": False} for row in (values.tolist() if values.ndim == 1 else values)]


def _reply(reply: object, mode: str) -> Reply:
    if not isinstance(reply, dict) or not isinstance(reply.get("changed", False), bool):
        raise ProcessLost
    if "error" in reply:
        return {"error": error_of(reply)}
    if "value" not in reply:
        raise ProcessLost
    return {"value": FORMS[mode](reply["value"]), "changed": reply.get("changed", False)}


def imported(reply: object) -> Reply:
    """Return the reply to a submission's text: {"names": [...], "skipped": [...]}, short strings, or {"error": ...}."""
    if not isinstance(reply, dict) or not ("error" in reply or strings(reply.get("names"))):
        raise ProcessLost
    if "error" in reply:
        return {"error": error_of(reply)}
    return {"names": reply["names"], "skipped": reply["skipped"] if strings(reply.get("skipped")) else []}


def error_of(reply: object) -> Reply:
    """Return the error in a reply, with every field of its type; NO_ERROR if there is no valid one."""
    error = reply.get("error") if isinstance(reply, dict) else None
    if not isinstance(error, dict) or not strings(error.get("kinds")):
        return NO_ERROR
    line, text = error.get("line"), error.get("text")
    return {
        "kinds": error["kinds"][:MOST_KINDS],
        "text": printable(" ".join(text[:LONGEST_TEXT].split())) if isinstance(text, str) else "",
        "line": line if isinstance(line, int) else 0,
    }


def strings(value: object) -> bool:
    """Return whether a value is a list of at most MOST_WORDS short strings."""
    return (
        isinstance(value, list)
        and len(value) <= MOST_WORDS
        and all(isinstance(item, str) and len(item) <= LONGEST_TEXT for item in value)
    )


def _numbers(value: object, depth: int = 0) -> Any:
    """Return a number, array, Foreign or nested list of these; raise ProcessLost for any other value."""
    if value is None or type(value) in (bool, float, Foreign):
        return value
    if isinstance(value, np.ndarray) and value.ndim <= MOST_DIMENSIONS:
        return value if value.size or math.prod(filter(None, value.shape)) <= MOST_EMPTY else np.empty(0)
    if isinstance(value, list) and depth <= DEEPEST:
        return [_numbers(item, depth + 1) for item in value]
    raise ProcessLost


def _values(value: object) -> Any:
    """Return the values of a formula, a number each; or its unknown symbols, or what was returned instead of one."""
    if isinstance(value, dict) and value.get("form") in [*REMEDIES]:
        return {"form": value["form"]}
    if isinstance(value, dict):
        return {"strangers": value["strangers"]} if strings(value.get("strangers")) else {"strangers": []}
    if isinstance(value, list):
        are_numbers = [type(item) is float or (isinstance(item, np.ndarray) and item.ndim == 0) for item in value]
        pairs = zip(value, are_numbers, strict=True)
        return [item if is_number else Foreign("an object") for item, is_number in pairs]
    return _numbers(value)


def _drawing(value: object) -> Drawing | None:
    """Return the drawing in a reply; None if it is too large or invalid."""
    if not isinstance(value, dict) or not isinstance(value.get("lines"), list) or len(value["lines"]) > MOST_LINES:
        return None
    lines = [_line(line) for line in value["lines"]]
    complete = [line for line in lines if line is not None]
    if len(complete) < len(lines) or sum(len(line.points) for line in complete) > MOST_POINTS:
        return None
    labels = _label(value, "xlabel"), _label(value, "ylabel")
    showing, scales = (
        _pair(value.get(key), item_type) for key, item_type in (("labels_show", bool), ("scales", float))
    )
    if showing is None or scales is None or type(bent := value.get("bent")) is not float:
        return None
    return Drawing(tuple(complete), *labels, showing, scales, bent)


def _pair(value: object, item_type: type) -> Any:
    return (
        tuple(value) if isinstance(value, list) and [type(item) for item in value] == [item_type, item_type] else None
    )


def _line(line: Json) -> Line | None:
    points = line.get("points") if isinstance(line, dict) else None
    if not isinstance(points, np.ndarray) or points.dtype != np.float64 or points.ndim != 2 or points.shape[1] != 2:
        return None
    seen: list[Numbers] = [line.get(key) for key in ("shows", "within", "extent")]
    if not all(type(share) is float for share in seen):
        return None
    scatter = line.get("scatter") is True
    every = -(-len(points) // MOST_SCATTERED) if scatter and len(points) else 1
    return Line(points[::every], _label(line, "label"), scatter, *seen)


def _label(value: Reply, key: str) -> str:
    label = value.get(key)
    return label[:LONGEST_TEXT] if isinstance(label, str) else ""


FORMS = {"value": _numbers, "formula": _values, "drawing": _drawing}
