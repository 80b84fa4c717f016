"""Parse students' notebooks and modules in the sandbox, because a parser may need unlimited memory and time."""

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
    """A notebook or module cannot be parsed; the message says why."""


def cells_of(text: bytes) -> list[Json]:
    """Return the cells of a notebook in the form of `protocol.cells`, without running it; raise Unshown on failure."""
    return list(_read("cells", text))


def python_of(text: bytes) -> str:
    """Return the Python code of a notebook, without running it; raise Unshown on failure."""
    return str(_read("python", text))


def statements_of(text: bytes) -> str:
    """Return the statements of a module in normal form, without running it; raise Unshown on failure."""
    return str(_read("statements", text))


def _read(what: str, text: bytes) -> Any:
    try:
        process = _reader().process(READING.cpu)
    except ZygoteLost as lost:
        _reader.cache_clear()  # the next call starts a new reader
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
