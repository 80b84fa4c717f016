"""Reads students' notebooks and modules in a process of their own: a parser may need memory and time without end."""

import atexit
import functools
from typing import Any

from tam570.values import Json
from tam570_grader.sandbox.imports import python_class
from tam570_grader.sandbox.process import ProcessLost, ProcessTimeout
from tam570_grader.sandbox.replies import error_of
from tam570_grader.sandbox.zygote import ResourceLimits, Zygote, ZygoteLost

READING = ResourceLimits(memory=2**30, cpu=10, call=10)


class Unshown(Exception):
    """What cannot be read; the message says why."""


def cells_of(text: bytes) -> list[Json]:
    """Return the cells of a notebook, as `protocol.cells` describes them, or Unshown; nothing of it has run."""
    return list(_read("cells", text))


def python_of(text: bytes) -> str:
    """Return the code of a notebook without magics and what is no Python, or Unshown; nothing of it has run."""
    return str(_read("python", text))


def statements_of(text: bytes) -> str:
    """Return the statements of a module in one form, or Unshown; nothing of it has run."""
    return str(_read("statements", text))


def _read(what: str, text: bytes) -> Any:
    try:
        process = _reader().process(READING.cpu)
    except ZygoteLost as lost:
        _reader.cache_clear()  # the next one has a new reader
        raise ConnectionError(str(lost)) from None
    try:
        process.send({"read": what, "text": text})
        reply: Json = process.receive(lambda reply: reply)
    except ProcessTimeout:
        raise Unshown("it takes too long to read") from None
    except ProcessLost:
        raise Unshown("it takes too much memory to read") from None
    finally:
        process.end()
    if "error" in reply:
        raise Unshown(python_class(error_of(reply)))
    return reply["read"]


@functools.cache
def _reader() -> Zygote:
    zygote = Zygote([], READING)
    atexit.register(zygote.close)
    return zygote
