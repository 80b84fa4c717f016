"""Puts what was downloaded from Canvas, Moodle or Gradescope into `submitted/<student>/<assignment>/`."""

import csv
import io
from collections import defaultdict
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from tam570_grader.errors import UsageError, counted, warn, writing
from tam570_grader.grading import roster
from tam570_grader.grading.submissions import GIVEN, WORK, folder_of, of_folder, of_name
from tam570_grader.lms.archives import File, inside, members
from tam570_grader.lms.downloads import READERS, Handed
from tam570_grader.results.tables import cell, name_in, table, written

__all__ = ["listed", "run"]

COLUMNS = ("student", "name", "assignment", "file", "when", "late", "from", "note")
TABLE = "collected.csv"
NAMELESS = "cannot tell the assignment: give it with --assignment"
NOT_WORK = "neither a module (.py) nor a notebook (.ipynb): ask the student for one"
OLDER, RELEASED = "older", "came with the assignment"  # why a file is left, where all is well
OTHER = "another file counts: see which one, and name that after the assignment"
TWO = "another in the download goes to the same student: who is who on the roster?"
STRAY = {
    "canvas": "is not named as canvas names submissions",
    "moodle": "is not named as moodle names submissions",
    "gradescope": "is nobody's by submission_metadata.yml",
}
STRANGER = "is on no row of the roster"


@dataclass(frozen=True)
class Taken:
    """One file with its student, its assignment and the name that it gets; without one `note` says why."""

    student: str
    handed: Handed
    slug: str
    target: str
    note: str = ""


def listed(path: Path, needed: Collection[str] = COLUMNS) -> list[dict[str, str]]:
    """The rows of collected.csv by column; UsageError if it lacks one that is needed."""
    heading, *rows = table(path, "surrogateescape")  # names of files may hold any bytes
    if lacking := {*needed} - {*heading}:
        raise UsageError(f"{path} has no column {', '.join(sorted(lacking))}: name the table that `collect` wrote")
    return [dict(zip(heading, [*map(name_in, row), *[""] * len(heading)], strict=False)) for row in rows]


def run(
    source: Path, system: str, students: Path | None, out: Path, known: Sequence[str], given: str | None = None
) -> int:
    """Collect a download; the exit code is 1 if anything is left that needs the instructor."""
    if not source.exists():
        raise UsageError(f"{source} does not exist: name the zip file that {system} gave you, or its folder")
    people = roster.by_id(roster.people(students)) if students else {}
    found = list(READERS[system](members(source)))
    strays = [one for one in found if isinstance(one, File)]
    unpacked = [each for one in found if isinstance(one, Handed) for each in _unpacked(one)]
    if not unpacked:
        raise UsageError(f"{source} holds nothing that is named as {system} names submissions: is --from right?")
    rows = _newest(_told_apart([_taken(one, people, known, given) for one in unpacked]))
    _write(rows, out)
    troubles = _newer_notebooks(rows, out)
    troubles += [_told(row) for row in rows if row.note and row.note not in (OLDER, RELEASED)]
    troubles += [f"{stray.path} {stray.refused or STRAY[system]}" for stray in strays]
    troubles += [f"{row} {STRANGER}" for row in _strangers(rows, people)] if students else []
    for line in troubles:
        warn(line)
    _say(rows, out, people)
    return 1 if troubles else 0


def _unpacked(handed: Handed) -> list[Handed]:
    """The file itself, or the work that a zip file holds."""
    if handed.file.refused or not handed.title.lower().endswith(".zip"):
        return [handed]
    held = inside(handed.file)
    work = [one for one in held if one.refused or one.path.endswith(WORK)]
    outer = handed.file.path  # by its name a page is handed back
    named = [(replace(one, path=f"{outer}/{one.path}".rstrip("/")), one.path.rsplit("/", 1)[-1]) for one in work]
    return [replace(handed, file=file, title=title) for file, title in named] or [handed]


def _taken(handed: Handed, people: Mapping[str, roster.Person], known: Sequence[str], given: str | None) -> Taken:
    person = next((people[key] for key in handed.ids if key in people), None)
    student = folder_of(person.ids[0] if person else handed.ids[0])
    title = handed.title.removesuffix(".txt") if handed.title.endswith(".py.txt") else handed.title
    slug = given or of_name(title, known) or ""
    suffix = Path(title).suffix.lower()
    if handed.file.refused:
        return Taken(student, handed, slug, "", handed.file.refused)
    if suffix not in WORK:
        return Taken(student, handed, slug, "", NOT_WORK)
    if GIVEN.fullmatch(Path(title).stem):
        return Taken(student, handed, slug, "", RELEASED)
    return Taken(student, handed, slug, f"{slug}{suffix}", "") if slug else Taken(student, handed, "", "", NAMELESS)


def _told_apart(rows: Sequence[Taken]) -> list[Taken]:
    """The rows, none with a place where two people would be one student: a name may be anybody's."""
    who = defaultdict[str, set[tuple[str, ...]]](set)
    for row in rows:
        who[row.student].add(row.handed.ids)
    return [replace(row, target="", note=TWO) if row.target and len(who[row.student]) > 1 else row for row in rows]


def _newest(rows: Sequence[Taken]) -> list[Taken]:
    """All rows, of which the best of each student, assignment and form alone keeps its place."""
    best: dict[tuple[str, str], Taken] = {}
    for row in rows:
        key = row.student, row.target
        if row.target and (key not in best or _rank(row) >= _rank(best[key])):
            best[key] = row
    found = [_passed_over(row, best[row.student, row.target]) if row.target else row for row in rows]
    return sorted(found, key=lambda row: (row.student, row.slug, row.handed.order))


def _rank(row: Taken) -> tuple[bool, tuple[Any, ...]]:
    """A file that is named after its assignment goes before scratch, then the newest."""
    return of_name(row.handed.title, [row.slug]) is not None, row.handed.order


def _passed_over(row: Taken, best: Taken) -> Taken:
    """The row, without its place where another has it."""
    if row is best:
        return row
    return replace(row, target="", note=OLDER if row.handed.order < best.handed.order else OTHER)


def _write(rows: Sequence[Taken], out: Path) -> None:
    """The files in their folders, and the table of who, what and when."""
    path, text = out.parent / TABLE, io.StringIO()
    csv.writer(text).writerows(map(cell, row) for row in [COLUMNS, *_all_rows(path, rows)])
    with writing(out):
        for row in rows:
            if row.target:
                place = out / row.student / row.slug
                place.mkdir(parents=True, exist_ok=True)
                written(place / row.target, row.handed.file.data)
        out.mkdir(parents=True, exist_ok=True)
        written(path, text.getvalue())


def _all_rows(path: Path, rows: Sequence[Taken]) -> list[tuple[str, ...]]:
    """The rows of the table: of earlier downloads those that no row of this one replaces."""
    new = {(row.student, row.slug, row.target) for row in rows}
    earlier = [tuple(row[name] for name in COLUMNS) for row in (listed(path) if path.exists() else [])]
    kept = [row for row in earlier if row[2] and (row[0], row[2], row[3]) not in new]
    return sorted([*kept, *map(_row, rows)], key=lambda row: (row[0], row[2]))


def _row(one: Taken) -> tuple[str, ...]:
    handed = one.handed
    late = "LATE" if handed.late else ""
    return one.student, handed.name, one.slug, one.target, handed.when, late, handed.file.path, one.note


def _told(row: Taken) -> str:
    return f"{row.handed.file.path} of {row.student} is not collected: {row.note}"


def _newer_notebooks(rows: Iterable[Taken], out: Path) -> list[str]:
    """Notebooks that came after the module that counts: a sentence for each."""
    kept = [row for row in rows if row.target]
    modules = {(row.student, row.slug): row.handed.order for row in kept if row.target.endswith(".py")}
    found = []
    for row in kept:
        folder = out / row.student / row.slug
        newer = row.target.endswith(".ipynb") and row.handed.order > modules.get((row.student, row.slug), ())
        counts = of_folder(folder, row.student, row.slug, folder).path if newer else None
        if counts and counts.suffix == ".py":
            remedy = "delete the module if the notebook should count"
            found.append(f"{row.handed.file.path} of {row.student} is newer than {counts}, which counts: {remedy}")
    return found


def _strangers(rows: Iterable[Taken], people: Mapping[str, roster.Person]) -> list[str]:
    known = {key for one in rows for key in one.handed.ids if key in people}
    return sorted({f"{one.student} ({one.handed.name})" for one in rows if not known & {*one.handed.ids}})


def _say(rows: Sequence[Taken], out: Path, people: Mapping[str, roster.Person]) -> None:
    """How many were collected, how many late, and who on the roster handed in nothing."""
    kept = [row for row in rows if row.target]
    late = sum(row.handed.late for row in kept)
    count = f"{counted(len(kept), 'file')} of {counted(len({row.student for row in kept}), 'student')}"
    count += f", {late} late" if late else ""
    print(f"{out}: {count}; {out.parent / TABLE} lists them")
    absent = sorted({folder_of(one.ids[0]) for one in people.values()} - {row.student for row in rows})
    if absent:
        print(f"{len(absent)} on the roster handed in nothing: {', '.join(absent)}")
