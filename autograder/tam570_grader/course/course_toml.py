"""Read course.toml, and raise UsageError with the file's name for invalid entries."""

import math
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

from tam570.values import Json
from tam570_grader.checks import assignments
from tam570_grader.errors import UsageError

FILE = "course.toml"
COLUMNS = ("canvas", "blackboard", "brightspace")  # keys: an assignment's column in these systems' gradebooks
COPY = "made-by-course.toml"  # name of the copy in a generated course; another name, so that it is not adapted again


def toml(path: Path) -> Json:
    """Return the tables of the file; raise UsageError if it cannot be read."""
    import tomllib  # imported late: few commands need it

    try:
        return tomllib.loads(path.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise UsageError(f"cannot read {path}: {error}") from None


def must(path: Path, holds: bool, problem: str) -> None:
    """Raise UsageError with the file's name and the problem, unless the condition holds."""
    if not holds:
        raise UsageError(f"{path}: {problem}")


def is_number(value: object, most: float = math.inf) -> bool:
    """Return whether a value is a finite number from 0 to `most`."""
    if not isinstance(value, int | float) or isinstance(value, bool):
        return False
    return 0 <= value <= most and math.isfinite(value)


def no_other(path: Path, where: str, names: Iterable[str], allowed: Iterable[str]) -> None:
    """Raise UsageError for the first name that is not allowed, and suggest the most similar allowed one."""
    import difflib

    allowed = [*allowed]
    for name in sorted({*names} - {*allowed}):
        near = difflib.get_close_matches(name, allowed, 1) or [", ".join(allowed) or "none"]
        raise UsageError(f"{path}: {where}{name} is not known; do you mean {near[0]}?")


def by_slug(path: Path, tables: Json, slugs: Sequence[str]) -> dict[str, tuple[str, Any]]:
    """Return key and table of each assignment by slug; raise UsageError if an assignment has two tables."""
    tables_by_slug: dict[str, tuple[str, Any]] = {}
    for key, table in tables.items():
        if (slug := assignments.slug_of(key, slugs)) is not None:
            first, _ = tables_by_slug.setdefault(slug, (key, table))
            must(path, first == key, f"[{first}] and [{key}] are the same assignment: keep one")
    return tables_by_slug


def columns(course: Path, system: str) -> dict[str, str]:
    """Return by slug the heading or id of the assignment's column in a system's gradebook, if course.toml names one."""
    path = course / COPY
    tables = by_slug(path, toml(path), assignments.slugs(course)) if path.is_file() else {}
    return {slug: str(table[system]) for slug, (_, table) in tables.items() if table.get(system)}
