"""Read `collected.csv`, the table that `collect` writes."""

import re
from collections.abc import Collection
from pathlib import Path

from tam570_grader.results.tables import by_column, name_in

COLUMNS = ("student", "name", "assignment", "file", "when", "late", "from", "note")
TABLE = "collected.csv"
# reasons for skipping a file that need no attention
MINOR = OLDER, SAME, RELEASED = "older", "same as the file that counts", "came with the assignment"


def listed(path: Path, needed: Collection[str] = COLUMNS) -> list[dict[str, str]]:
    """Return the rows of collected.csv by column; raise UsageError if a needed column is missing."""
    remedy = ": name the table that `collect` wrote"
    rows = by_column(path, needed, remedy, "surrogateescape")  # names of files may contain any bytes
    return [{name: name_in(cell) for name, cell in row.items()} for _, row in rows]


# the ending of a name, before what browsers append to it, and dots and spaces that Windows ignores
WORK = re.compile(r".*(\.py|\.ipynb)(?:\.txt|\.json)?[. ]*", re.IGNORECASE | re.DOTALL)


def form(name: str) -> str:
    """Return the ending .py or .ipynb that a name has, in lower case; "" if it has none."""
    return match[1].lower() if (match := WORK.fullmatch(name)) else ""


def is_zip(name: str) -> bool:
    """Return whether a file's name is that of a zip file."""
    return name.lower().endswith(".zip")
