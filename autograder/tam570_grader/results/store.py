"""Store the results of a run on disk, one line each, so that a run that is killed at any time can be resumed."""

import fcntl
import hashlib
import json
import os
import sys
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, BinaryIO

from tam570.values import Json
from tam570_grader.errors import UsageError
from tam570_grader.results import manual_points, records
from tam570_grader.results.manual_points import GradeRow
from tam570_grader.results.records import Result
from tam570_grader.results.tables import write_table, written

Key = tuple[str, str]  # student, assignment
Record = Json  # a parsed result line; its "digest" covers all that the result depends on
# fields that every result has, and those of each check in its "checks"
RESULT_FIELDS = {"student", "assignment", "status", "score", "max_score", "seed", "seconds", "isolation", "checks"}
CHECK_FIELDS = {"name", "part", "points", "max_points", "outcome", "message", "suspect"}


@dataclass(frozen=True, slots=True)
class StoredLine:
    """The position of a result in its file, and the fields that are needed most."""

    start: int
    length: int
    digest: str  # digest of all that the result depends on
    line_digest: str
    seed: int
    graded: GradeRow  # its row in the table of grades

    @property
    def scored(self) -> bool:
        return self.graded.score is not None


class Results(Mapping[Key, Record]):
    """The newest result of each student and assignment in a file, sorted; records are read from the file on access."""

    def __init__(self, file: BinaryIO, path: Path) -> None:
        self._file, self._path = file, path
        self.lines = dict[Key, StoredLine]()
        self._end, self._count = 0, 0  # offset behind the complete lines that were read, and their number
        try:
            self._look()
        except UsageError:
            file.close()
            raise

    def __getitem__(self, key: Key) -> Record:
        record: Record = json.loads(self.text(key))
        return record

    def __iter__(self) -> Iterator[Key]:
        return iter(sorted(self.lines))

    def __len__(self) -> int:
        return len(self.lines)

    def text(self, key: Key) -> bytes:
        """Return the result line of a student and assignment."""
        line = self.lines[key]
        return os.pread(self._file.fileno(), line.length, line.start)

    def result(self, key: Key) -> Result:
        """Return the result of a student and assignment; raise UsageError if its line is not a result."""
        try:
            return records.read(self[key])
        except (ValueError, TypeError, KeyError, AttributeError):
            raise UsageError(
                f"{self._path} holds a line on {' '.join(key)} that is not a result; grade again"
            ) from None

    def earned(self, key: Key) -> manual_points.Earned:
        """Return a function that reads the points of each check of a result."""
        return lambda: {check["name"]: check["points"] for check in self[key]["checks"]}

    def close(self) -> None:
        self._file.close()

    def _look(self) -> None:
        """Read new lines, except an incomplete last one."""
        self._file.seek(self._end)
        for text in self._file:
            if text.endswith(b"\n"):
                self._index(_record(text, self._path, self._count + 1), text)

    def _index(self, record: Record, text: bytes) -> None:
        line_digest = hashlib.blake2b(text, digest_size=12).hexdigest()
        graded = GradeRow(*(_kept_once(record[name]) for name in GradeRow._fields))
        digest = str(record.get("digest"))
        line = StoredLine(self._end, len(text), digest, line_digest, record["seed"], graded)
        self.lines[_kept_once(str(record["student"])), _kept_once(str(record["assignment"]))] = line
        self._end += len(text)
        self._count += 1


class ResultStore(Results):
    """`results.jsonl` and `grades.csv` in a folder, locked for one run.

    waits : called with a sentence before waiting for the end of another run there; by default, UsageError is raised
    """

    def __init__(self, folder: Path, waits: Callable[[str], None] | None = None) -> None:
        self._folder = folder
        super().__init__(_locked(folder, waits), folder / "results.jsonl")
        self._file.truncate(self._end)  # remove the incomplete line of a run that was killed

    def add(self, record: Record, text: bytes | None = None) -> None:
        """Append a result and flush it to the disk, unless it is stored already.

        text : the line, if it is already encoded
        """
        if self.get(key_of(record)) == record:
            return
        text = text or json.dumps(record, allow_nan=False).encode() + b"\n"
        self._file.write(text)
        self._file.flush()
        os.fsync(self._file.fileno())
        self._index(record, text)

    def close(self) -> None:
        """Write the table of grades; sort the result lines, and remove outdated ones."""
        self._look()  # an interrupt may have occurred between the writing of a line and its indexing
        adjustments = manual_points.read(self._folder)
        graded = adjustments.table(adjustments.row(self.lines[key].graded, self.earned(key)) for key in self)
        write_table(self._folder / "grades.csv", [GradeRow._fields, *graded])
        starts = [self.lines[key].start for key in self]
        if self._count > len(self) or starts != sorted(starts):  # last, as it replaces the locked file
            written(self._folder / "results.jsonl", (self.text(key).decode() for key in self))
        self._file.close()


def _locked(folder: Path, waits: Callable[[str], None] | None) -> BinaryIO:
    """Return the `results.jsonl` of a folder, open and locked."""
    path = folder / "results.jsonl"
    while True:
        file = _opened(path)
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            if not waits:
                file.close()
                raise UsageError(f"another run is writing to {folder}") from None
            waits(f"Another run is writing to {folder}: this one waits for its end.")
            fcntl.flock(file, fcntl.LOCK_EX)
        if path.exists() and os.path.samestat(os.fstat(file.fileno()), os.stat(path)):
            return file  # else a run that ended has replaced the file since it was opened
        file.close()


def _opened(path: Path) -> BinaryIO:
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        if path.exists() and not path.is_file():
            raise UsageError(f"cannot write results to {path.parent}: {path} is not a regular file; move it away")
        return open(path, "a+b")
    except OSError as error:
        raise UsageError(f"cannot write results to {path.parent}: {error.strerror}; name another folder") from None


def results(path: Path) -> Results:
    """Return the results in a folder or a `results.jsonl`; raise UsageError if there are none."""
    file = path if path.is_file() else path / "results.jsonl"
    if not file.is_file():
        raise UsageError(f"there are no results in {path}; make them with: tam570-grader grade ... --out {path}")
    try:
        return Results(open(file, "rb"), file)  # noqa: SIM115  closed with the results
    except OSError as error:
        raise UsageError(f"cannot read results from {path}: {error.strerror}") from None


def _record(line: bytes, path: Path, number: int) -> Record:
    """Return the record in a line; raise UsageError if it is not a result, or of another format."""
    try:
        record: Record = json.loads(line)
        is_whole = record.keys() >= RESULT_FIELDS and all(check.keys() >= CHECK_FIELDS for check in record["checks"])
    except (ValueError, TypeError, AttributeError):
        is_whole = False
    if not is_whole:
        raise UsageError(f"{path} holds a line that is not a result (line {number}); move the file away")
    if record.get("format") != records.FORMAT:
        raise UsageError(
            f"{path} holds a result of another version of the grader (line {number}); grade again, into a new folder"
        )
    return record


def _kept_once(value: Any) -> Any:
    """Return the value, interned if it is a string: a class has few names and many results."""
    return sys.intern(value) if type(value) is str else value


def key_of(record: Record) -> Key:
    """Return student and assignment of a record."""
    return str(record["student"]), str(record["assignment"])
