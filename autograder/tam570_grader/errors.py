"""What ends a command or a submission, and what an instructor is told: no traceback, nothing that moves the cursor."""

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
    """Something that was asked for cannot be done; the message names the input and the remedy."""


class Over(BaseException):
    """Nothing more of this submission is graded on this worker, whatever errors of its code are borne with."""


def printable(text: str) -> str:
    """Return a text with what is no text escaped: what moves a terminal's cursor, and bytes that are not UTF-8."""
    if text.isprintable():
        return text
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode() for c in text)


def warn(message: str, prefix: str = "warning: ") -> None:
    """Tell the instructor a sentence; names of files and students in it may hold anything."""
    print(f"tam570-grader: {prefix}{printable(message)}", file=sys.stderr)  # noqa: T201  names are escaped here


def say(text: str, *, error: bool = False) -> None:
    """Print lines; names and results in them may hold anything, and no line moves the cursor."""
    print("\n".join(map(printable, text.split("\n"))), file=sys.stderr if error else sys.stdout, flush=True)


def counted(n: int, word: str) -> str:
    """So many of what a word names: 1 file, 2 files."""
    return f"{n} {word}" if n == 1 else f"{n} {word}s"


def progress(items: Iterable[T], total: int, unit: str) -> Iterator[T]:
    """Yield the items, with a bar on a terminal after a second."""
    if not sys.stderr.isatty():
        yield from items
        return
    from tqdm import tqdm

    tqdm.monitor_interval = 0  # no thread: processes of ours are forked
    yield from tqdm(items, total=total, unit=unit, leave=False, delay=1.0)


@contextmanager
def writing(path: Path) -> Iterator[None]:
    """Raise UsageError for what cannot be written to a path that was asked for."""
    try:
        yield
    except OSError as error:
        many = isinstance(error, shutil.Error) and isinstance(error.args[0], list)
        why = error.args[0][0][2] if many else error.strerror or error  # the first of many
        remedy = REMEDIES.get(error.errno or 0, "name another path")
        raise UsageError(f"cannot write to {path}: {why}; {remedy}") from None
