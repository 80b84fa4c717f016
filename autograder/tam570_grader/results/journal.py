"""The results of a run on disk: one line each, safe from a kill at any moment, found again by the next run."""

import csv
import fcntl
import io
import json
import os
from collections.abc import Iterable
from pathlib import Path
from typing import Any, BinaryIO

from tam570_grader.errors import UsageError

__all__ = ["FORMULA", "Book", "Record", "cell", "name_in", "read", "seed_of", "written"]

Record = dict[str, Any]  # a result line, with "digest": of all that the result depends on
# what every result has, and every mark in its "checks"
RESULT = {"student", "assignment", "status", "score", "max_score", "seed", "seconds", "isolation", "checks"}
MARK = {"name", "part", "points", "max_points", "outcome", "message", "suspect"}
# how formulas begin; spreadsheets take the wide forms for the narrow ones
FORMULA = "=", "+", "-", "@", "\t", "\r", "\n", "\uff1d", "\uff0b", "\uff0d", "\uff20"


class Book:
    """`results.jsonl` and `grades.csv` in a folder."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._file = _locked(folder)
        try:
            self._records = self._read()
        except UsageError:
            self._file.close()
            raise

    @property
    def seed(self) -> int | None:
        """The seed of the results that are there."""
        return seed_of(self._records.values())

    def add(self, record: Record) -> None:
        """Write a result down, if it is new; when this returns, it is on the disk."""
        if self._records.get(_key(record)) == record:
            return
        self._file.write(json.dumps(record).encode() + b"\n")
        self._file.flush()
        os.fsync(self._file.fileno())
        self._records[_key(record)] = record

    def records(self) -> list[Record]:
        """The newest result of every student and assignment, in order."""
        return [self._records[key] for key in sorted(self._records)]

    def close(self) -> None:
        """Write the table of grades, and drop the lines that newer ones have replaced."""
        self._file.seek(0)
        replaced = self._file.read().count(b"\n") > len(self._records)
        if replaced:
            self._records = self._read()  # an interrupt may have come between a line and its record
        written(self._folder / "grades.csv", grades(self.records()))
        if replaced:  # last: the lock is on the file that goes
            lines = "".join(json.dumps(record) + "\n" for record in self._records.values())
            written(self._folder / "results.jsonl", lines)
        self._file.close()

    def _read(self) -> dict[tuple[str, str], Record]:
        """The results by student and assignment; a last line that a kill cut short is taken away."""
        self._file.seek(0)
        data = self._file.read()
        whole = data[: data.rfind(b"\n") + 1]
        self._file.truncate(len(whole))
        return _parsed(whole, self._folder / "results.jsonl")


def _locked(folder: Path) -> BinaryIO:
    """The `results.jsonl` of a folder, open and ours alone."""
    while True:
        file = _opened(folder)
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            file.close()
            raise UsageError(f"another run is writing to {folder}") from None
        if _is_at(file, folder / "results.jsonl"):
            return file
        file.close()


def _is_at(file: BinaryIO, path: Path) -> bool:
    """Whether an open file is the one of that name: a run that ends may have put another in its place."""
    return path.exists() and os.path.samestat(os.fstat(file.fileno()), os.stat(path))


def _opened(folder: Path) -> BinaryIO:
    path = folder / "results.jsonl"
    try:
        folder.mkdir(parents=True, exist_ok=True)
        if path.exists() and not path.is_file():
            raise UsageError(f"cannot write results to {folder}: {path} is not a regular file; move it away")
        return open(path, "a+b")
    except OSError as error:
        raise UsageError(f"cannot write results to {folder}: {error.strerror}; name another folder") from None


def read(path: Path) -> list[Record]:
    """The newest result of every student and assignment, in a folder of results or its `results.jsonl`."""
    path = path / "results.jsonl" if path.is_dir() else path
    try:
        data = path.read_bytes()
    except OSError as error:
        raise UsageError(f"cannot read results from {path}: {error.strerror}") from None
    return list(_parsed(data[: data.rfind(b"\n") + 1], path).values())


def seed_of(records: Iterable[Record]) -> int | None:
    """The seed that these results have in common; None if there are none."""
    seeds = {int(record["seed"]) for record in records}
    if len(seeds) > 1:
        raise UsageError(
            "these results have more than one seed: give the key that they were varied by (--vary), or a --seed"
        )
    return next(iter(seeds), None)


def _parsed(lines: bytes, path: Path) -> dict[tuple[str, str], Record]:
    """The results by student and assignment."""
    records = {}
    for number, line in enumerate(lines.splitlines(), start=1):
        if (record := _result(line)) is None:
            raise UsageError(f"{path} holds a line that is not a result (line {number}); move the file away")
        records[_key(record)] = record
    return records


def _result(line: bytes) -> Record | None:
    """The result in a line; None if it is none."""
    try:
        record: Record = json.loads(line)
        whole = record.keys() >= RESULT and all(mark.keys() >= MARK for mark in record["checks"])
    except (ValueError, TypeError, AttributeError):
        return None
    return record if whole else None


def written(path: Path, text: str) -> None:
    """Put the text in place of the file, whole or not at all."""
    draft = path.with_name(path.name + ".new")
    with open(draft, "w", encoding="utf-8", newline="") as file:
        file.write(text)
        file.flush()
        os.fsync(file.fileno())
    os.replace(draft, path)


def grades(records: Iterable[Record]) -> str:
    """A table for a spreadsheet: a row for each student and assignment."""
    table = io.StringIO()
    columns = ("student", "assignment", "status", "score", "max_score")
    writer = csv.writer(table)
    writer.writerow(columns)
    for record in records:
        writer.writerow([cell(record[column]) for column in columns])
    return table.getvalue()


def cell(value: Any) -> Any:
    """A value that no spreadsheet takes for a formula: a quote stands before what could be one."""
    return f"'{value}" if isinstance(value, str) and _could_be_formula(value) else value


def name_in(cell: str) -> str:
    """The text that was made into a cell."""
    return cell[1:] if cell.startswith("'") and _could_be_formula(cell) else cell


def _could_be_formula(text: str) -> bool:
    """By how it begins, quotes aside, so that a quote of its own is told from ours."""
    return text.lstrip("'").startswith(FORMULA)


def _key(record: Record) -> tuple[str, str]:
    return str(record["student"]), str(record["assignment"])
