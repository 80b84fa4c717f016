"""The table of what was collected: collected.csv."""

from collections.abc import Collection
from pathlib import Path

from tam570_grader.errors import UsageError
from tam570_grader.results.tables import name_in, table

COLUMNS = ("student", "name", "assignment", "file", "when", "late", "from", "note")


TABLE = "collected.csv"


def listed(path: Path, needed: Collection[str] = COLUMNS) -> list[dict[str, str]]:
    """Return the rows of collected.csv by column; UsageError if it lacks one that is needed."""
    heading, *rows = table(path, "surrogateescape")  # names of files may hold any bytes
    if lacking := {*needed} - {*heading}:
        raise UsageError(f"{path} has no column {', '.join(sorted(lacking))}: name the table that `collect` wrote")
    return [dict(zip(heading, [*map(name_in, row), *[""] * len(heading)], strict=False)) for row in rows]


WORK = (".py", ".ipynb")


def form(name: str) -> str:
    """Return which of WORK a file is by its name, in any case and with the ending .txt that browsers add.

    "" for none.
    """
    plain = name.lower()
    plain = plain.removesuffix(".txt") if plain.endswith(".py.txt") else plain
    return next((ending for ending in WORK if plain.endswith(ending)), "")
