"""The table of what was collected: collected.csv."""

from collections.abc import Collection
from pathlib import Path

from tam570_grader.results.tables import by_column, name_in

COLUMNS = ("student", "name", "assignment", "file", "when", "late", "from", "note")
TABLE = "collected.csv"
MINOR = OLDER, RELEASED = "older", "came with the assignment"  # why a file is left, where all is well


def listed(path: Path, needed: Collection[str] = COLUMNS) -> list[dict[str, str]]:
    """Return the rows of collected.csv by column; UsageError if it lacks one that is needed."""
    remedy = ": name the table that `collect` wrote"
    rows = by_column(path, needed, remedy, "surrogateescape")  # files' names: any bytes
    return [{name: name_in(cell) for name, cell in row.items()} for _, row in rows]


WORK = (".py", ".ipynb")


def form(name: str) -> str:
    """Return the ending of WORK that a name has, in any case, also before the .txt that browsers add; else ""."""
    plain = name.lower()
    plain = plain.removesuffix(".txt") if plain.endswith(".py.txt") else plain
    return next((ending for ending in WORK if plain.endswith(ending)), "")
