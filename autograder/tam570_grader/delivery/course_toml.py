"""course.toml as it stands in the file, and the sentences that name what does not fit."""

import difflib
import tomllib
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from tam570_grader.errors import UsageError

__all__ = ["COPY", "FILE", "must", "no_other", "toml"]

FILE = "course.toml"
COPY = "made-by-course.toml"  # what it said, in the course that was made by it: no command makes another of that


def toml(path: Path) -> dict[str, Any]:
    """The tables of the file; UsageError if it cannot be read."""
    try:
        return tomllib.loads(path.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise UsageError(f"cannot read {path}: {error}") from None


def must(path: Path, holds: bool, says: str) -> None:
    """UsageError, with the file, unless it holds."""
    if not holds:
        raise UsageError(f"{path}: {says}")


def no_other(path: Path, where: str, names: Iterable[str], known: Iterable[str]) -> None:
    """UsageError for a name that is not known, with the nearest one that is."""
    known = [*known]
    for name in sorted({*names} - {*known}):
        near = difflib.get_close_matches(name, known, 1) or [", ".join(known) or "none"]
        raise UsageError(f"{path}: {where}{name} is not known; do you mean {near[0]}?")
