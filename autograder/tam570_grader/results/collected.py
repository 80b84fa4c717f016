"""Read `collected.csv`, the table that `collect` writes."""

from collections.abc import Collection
from pathlib import Path

from tam570_grader.results.tables import by_column, name_in

COLUMNS = ("student", "name", "assignment", "file", "when", "late", "from", "note")
TABLE = "collected.csv"
MINOR = OLDER, RELEASED = "older", "came with the assignment"  # reasons for skipping a file that need no attention


def listed(path: Path, needed: Collection[str] = COLUMNS) -> list[dict[str, str]]:
    """Return the rows of collected.csv by column; raise UsageError if a needed column is missing."""
    remedy = ": name the table that `collect` wrote"
    rows = by_column(path, needed, remedy, "surrogateescape")  # names of files may contain any bytes
    return [{name: name_in(cell) for name, cell in row.items()} for _, row in rows]


WORK = (".py", ".ipynb")


def form(name: str) -> str:
    """Return the ending in WORK that a name has, ignoring case and a .txt that browsers append to .py; else ""."""
    plain = name.lower()
    plain = plain.removesuffix(".txt") if plain.endswith(".py.txt") else plain
    return next((ending for ending in WORK if plain.endswith(ending)), "")


def is_zip(name: str) -> bool:
    """Return whether a file's name is that of a zip file."""
    return name.lower().endswith(".zip")
