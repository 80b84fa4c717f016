"""Read tables from any spreadsheet; write files atomically, and tables without cells that spreadsheets evaluate."""

import codecs
import contextlib
import csv
import io
import os
import re
from collections.abc import Iterable, Iterator
from itertools import zip_longest
from pathlib import Path
from typing import TypeVar

from tam570_grader.errors import UsageError, say, warn

V = TypeVar("V")
DELIMITERS = ",;\t"
# first characters of formulas; spreadsheets treat the full-width forms alike
FORMULA = "=+\\-@\t\r\n\uff1d\uff0b\uff0d\uff20"
# where a cell begins: at the start, or where a spreadsheet with another delimiter splits (also before own quotes)
START = r"(?:\A|(?<=[;\t\r\n]))"
BEFORE_FORMULA = re.compile(rf"{START}(?='*[{FORMULA}])")
QUOTED = re.compile(rf"({START})'(?='*[{FORMULA}])")


def written(path: Path, content: str | bytes | Iterable[str]) -> None:
    """Write text, its parts or bytes to a file atomically: write another file, flush it to the disk, and rename it."""
    draft = path.with_name(path.name + ".new")
    parts = [content] if isinstance(content, str | bytes) else content
    try:
        with open(draft, "wb") as file:
            file.writelines(part.encode(errors="surrogateescape") if isinstance(part, str) else part for part in parts)
            file.flush()
            os.fsync(file.fileno())
        os.replace(draft, path)
    except OSError:
        draft.unlink(missing_ok=True)  # the disk may be full
        raise


def write_in(folder: Path, name: str, text: str) -> None:
    """Write a file atomically into a folder that another user may change; never follow a link there."""
    directory = os.open(folder, os.O_RDONLY | os.O_DIRECTORY | os.O_NOFOLLOW)
    draft = f".{name}.new"
    try:
        with contextlib.suppress(FileNotFoundError):
            os.unlink(draft, dir_fd=directory)
        flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_NOFOLLOW
        with open(os.open(draft, flags, 0o644, dir_fd=directory), "w", encoding="utf-8") as file:
            file.write(text)  # no fsync: a lost page can be made again from the results
        os.replace(draft, name, src_dir_fd=directory, dst_dir_fd=directory)
    finally:
        os.close(directory)


def write_table(path: Path | None, rows: Iterable[Iterable[object]], *, exact: bool = False) -> None:
    """Write a table atomically as CSV, or print it if `path` is None.

    exact : do not quote formulas, for systems that match names; warn about cells that could be formulas
    """
    rows = [list(row) for row in rows]
    if exact and (odd := sorted({str(text) for row in rows for text in row if text != cell(text)})):
        warn(
            "import the table without opening it in a spreadsheet, which may take these for formulas: "
            f"{', '.join(map(repr, odd[:20]))}"
        )
    text = io.StringIO()
    csv.writer(text).writerows(rows if exact else ([cell(value) for value in row] for row in rows))  # noqa: TID251
    if path is None:
        say(text.getvalue().replace("\r\n", "\n").removesuffix("\n"))
    else:
        written(path, text.getvalue())


def cell(value: V) -> V:
    """Return a cell with a quote before everything that a spreadsheet could take for a formula."""
    return BEFORE_FORMULA.sub(r"\g<0>'", value) if isinstance(value, str) else value  # type: ignore[return-value]  # a str, too


def name_in(cell: str) -> str:
    """Return the text from which `cell` made a cell."""
    return QUOTED.sub(r"\1", cell)


def table(path: Path) -> list[list[str]]:
    """Return the nonempty rows of a CSV file with any of the DELIMITERS."""
    return [row for _, row in lines(path)]


def by_column(
    path: Path, needed: Iterable[str], remedy: str, errors: str = "strict"
) -> Iterator[tuple[int, dict[str, str]]]:
    """Yield line number and cells by column of each row of a CSV file; UsageError if a needed column is missing."""
    (_, heading), *rows = lines(path, errors)
    names = [name.strip().lower() for name in heading]
    if lacking := {*needed} - {*names}:
        raise UsageError(f"{path} has no column {', '.join(sorted(lacking))}{remedy}")
    for line, row in rows:
        yield line, dict(zip_longest(names, row[: len(names)], fillvalue=""))


def lines(path: Path, errors: str = "strict") -> list[tuple[int, list[str]]]:
    """Return the nonempty rows of a CSV file, each with the number of its last line; `errors` as in `open`."""
    try:
        with open(path, "rb") as raw:
            is_wide = raw.read(2) in (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)  # Blackboard's, Excel's Unicode text
        with open(path, newline="", encoding="utf-16" if is_wide else "utf-8-sig", errors=errors) as file:
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
