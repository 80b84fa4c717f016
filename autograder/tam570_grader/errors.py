"""Exceptions that end a command or a submission, and output to the instructor without terminal control characters."""

import errno
import shutil
import sys
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TypeVar

T = TypeVar("T")
REMEDIES = {errno.ENOENT: "make its folder first", errno.ENOSPC: "make room on the disk"}


class UsageError(Exception):
    """The command cannot do what the user requested; the message names the input and the remedy."""


class Over(BaseException):
    """End of the grading of a submission; a BaseException, so that no `except Exception` catches it."""


def printable(text: str) -> str:
    """Return a text with unprintable characters escaped: terminal control characters and undecodable bytes."""
    if text.isprintable():
        return text
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode() for c in text)


def warn(message: str, prefix: str = "warning: ") -> None:
    """Print a sentence to stderr, with unprintable characters (in names of files and students) escaped."""
    print(f"tam570-grader: {prefix}{printable(message)}", file=sys.stderr)  # noqa: T201  names are escaped here


def say(text: str, *, error: bool = False) -> None:
    """Print lines, with unprintable characters (in names and results) escaped."""
    print("\n".join(map(printable, text.split("\n"))), file=sys.stderr if error else sys.stdout, flush=True)


def with_remedy(error: OSError) -> str:
    """Return the text of an error, and its remedy if there is one."""
    return "; ".join(filter(None, [str(error), REMEDIES.get(error.errno or 0)]))


def counted(n: int, word: str) -> str:
    """Return a number with its noun, in the plural except for 1: 1 file, 2 files."""
    return f"{n} {word}" if n == 1 else f"{n} {word}s"


def progress(items: Iterable[T], total: int, unit: str) -> Iterator[T]:
    """Yield the items; on a terminal, show a progress bar after one second."""
    if not sys.stderr.isatty():
        yield from items
        return
    from tqdm import tqdm

    tqdm.monitor_interval = 0  # disables tqdm's thread: workers are forked only from a single-threaded process
    yield from tqdm(items, total=total, unit=unit, leave=False, delay=1.0)


@contextmanager
def writing(path: Path) -> Iterator[None]:
    """Raise UsageError, with a remedy, if the block cannot write to this path (which the user named)."""
    try:
        yield
    except OSError as error:
        many = isinstance(error, shutil.Error) and isinstance(error.args[0], list)
        why = error.args[0][0][2] if many else error.strerror or error  # the first error of shutil.copytree
        remedy = REMEDIES.get(error.errno or 0, "name another path")
        raise UsageError(f"cannot write to {path}: {why}; {remedy}") from None
