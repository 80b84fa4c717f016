"""Files of text and tables: read from any spreadsheet, written whole or not at all, with no cell that is a formula."""

import csv
import os
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from tam570_grader.errors import UsageError

__all__ = ["FORMULA", "cell", "lines", "name_in", "table", "written"]

DELIMITERS = ",;\t"
# how formulas begin; spreadsheets take the wide forms for the narrow ones
FORMULA = "=", "+", "-", "@", "\t", "\r", "\n", "\uff1d", "\uff0b", "\uff0d", "\uff20"


def written(path: Path, whole: str | bytes | Iterable[str]) -> None:
    """Put the text, its parts or the bytes in place of the file, whole or not at all."""
    draft = path.with_name(path.name + ".new")
    parts = [whole] if isinstance(whole, str | bytes) else whole
    try:
        with open(draft, "wb") as file:
            file.writelines(one.encode(errors="surrogateescape") if isinstance(one, str) else one for one in parts)
            file.flush()
            os.fsync(file.fileno())
        os.replace(draft, path)
    except OSError:
        draft.unlink(missing_ok=True)  # a full disk needs the room
        raise


def cell(value: Any) -> Any:
    """A value that no spreadsheet takes for a formula: a quote stands before what could be one."""
    return f"'{value}" if isinstance(value, str) and _could_be_formula(value) else value


def name_in(cell: str) -> str:
    """The text that was made into a cell."""
    return cell[1:] if cell.startswith("'") and _could_be_formula(cell) else cell


def _could_be_formula(text: str) -> bool:
    """By how it begins, quotes aside, so that a quote of its own is told from ours."""
    return text.lstrip("'").startswith(FORMULA)


def table(path: Path, errors: str = "strict") -> list[list[str]]:
    """The rows of a CSV file that are not empty, whatever separates its cells."""
    return [row for _, row in lines(path, errors)]


def lines(path: Path, errors: str = "strict") -> list[tuple[int, list[str]]]:
    """The rows of a CSV file that are not empty, each with the line on which it ends; `errors` as `open` has it."""
    try:
        with open(path, newline="", encoding="utf-8-sig", errors=errors) as file:
            first = file.readline()
            file.seek(0)
            reader = csv.reader(file, delimiter=max(DELIMITERS, key=first.count))
            rows = [(reader.line_num, row) for row in reader if any(row)]
    except UnicodeDecodeError:
        raise UsageError(f"{path} is not text in UTF-8; save it as CSV (UTF-8)") from None
    except (OSError, csv.Error) as error:
        raise UsageError(f"cannot read {path}: {getattr(error, 'strerror', None) or error}") from None
    if not rows:
        raise UsageError(f"{path} is empty; export it again")
    return rows
