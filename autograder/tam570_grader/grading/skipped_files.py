"""List files in a class's folder that are not graded, and add a row for each student who handed in nothing."""

import os
import unicodedata
from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Sequence
from itertools import product
from pathlib import Path

from tam570_grader.checks.assignments import slug_of
from tam570_grader.errors import printable
from tam570_grader.grading import roster
from tam570_grader.grading.submissions import (
    GIVEN,
    MOST_NAMES,
    BadPath,
    Submission,
    entries,
    holds_assignments,
    holds_students,
    of_name,
)
from tam570_grader.results.collected import MINOR, TABLE, form, listed

PACKED = (".zip", ".txt", ".gz", ".7z", ".rar", ".tar")  # endings of files that students hand in by mistake
TWINS = "each has its own row, whose name ends in a code; rename all but one"
REMEDY = "name it after its assignment, as hw08.py, or name the assignment with --assignment"


def skipped_files(
    paths: Iterable[Path], work: Sequence[Submission], slugs: Sequence[str], students: Collection[str] = ()
) -> Iterator[str]:
    """Yield a sentence with the remedy for each file or folder at these paths that belongs to no submission.

    students : names of students' folders, from a roster
    """
    trees, graded = {submission.tree for submission in work}, {submission.path for submission in work}
    for folder in paths:
        if not folder.is_dir() or folder.resolve() in trees:
            continue
        is_class = holds_students(folder.absolute(), slugs, students)
        held = entries(folder.absolute())
        for name, count in Counter(unicodedata.normalize("NFC", entry.name) for entry, _ in held).items():
            if count > 1:
                yield f"{count} folders in {_shown(folder)} are called {name}, in different encodings: {TWINS}"
        hidden = (entry for entry in folder.iterdir() if entry.name.startswith((".", "__")) and not entry.is_symlink())
        for entry in hidden:
            if entry.is_dir() and holds_assignments(entry, slugs, files=False):
                yield f"{_shown(entry)} is not graded: its name begins with {entry.name[0]}; rename it"
        for entry, is_folder in held:
            is_students = is_folder and (is_class or not slug_of(entry.name, slugs))
            if entry in trees and is_students:
                yield from _beside(entry, graded, slugs)
            elif entry not in trees and entry not in graded and (is_students or not _names_another(entry, slugs)):
                yield f"{_shown(entry)}{_holding(entry)} is not graded: no name in it tells the assignment; {REMEDY}"
        yield from _not_collected(folder, {submission.key for submission in work})
    for submission in work:
        counts = submission.path and printable(submission.path.name)
        for other in submission.others:
            yield f"{other} of {submission.student} is not graded: {counts} is; remove the one that should not count"


def _collected(folder: Path) -> list[dict[str, str]]:
    """Return the rows of the table that `collect` wrote beside a folder, without files that need no attention."""
    path = folder.absolute().parent / TABLE
    return [row for row in listed(path) if row["note"] not in MINOR] if path.is_file() else []


def _not_collected(folder: Path, graded: set[tuple[str, str]]) -> Iterator[str]:
    """Yield a sentence for each file that `collect` could not place, if its student has no other work to grade."""
    for row in _collected(folder):
        if not row["file"] and (row["student"], row["assignment"]) not in graded:
            yield f"{printable(row['from'])} of {printable(row['student'])} is not collected: {row['note']}"


def _beside(folder: Path, graded: set[Path | None], slugs: Sequence[str]) -> Iterator[str]:
    """Yield a sentence for each further file in a student's folder that could be a submission."""
    try:
        held = entries(folder)
    except BadPath:  # the student's result reports it
        return
    strays = [
        entry
        for entry, is_folder in held
        if (is_folder or form(entry.name) or entry.suffix.lower() in PACKED)
        and not (entry in graded or GIVEN.fullmatch(entry.stem) or _names_another(entry, slugs))
    ]
    yield from (f"{_shown(entry)} is not graded; {REMEDY}" for entry in strays[:MOST_NAMES])
    if len(strays) > MOST_NAMES:
        yield f"{len(strays) - MOST_NAMES} more in {_shown(folder)} are not graded"


def _names_another(entry: Path, slugs: Sequence[str]) -> bool:
    """Return whether a file or folder is named after an assignment: it is not requested, or has a result."""
    return bool(
        slug_of(entry.name, slugs) or (not os.path.isdir(entry) and form(entry.name) and of_name(entry.name, slugs))
    )


def _holding(entry: Path) -> str:
    """Return the names of the first files in a folder, in parentheses."""
    try:
        names = [printable(inner.name[:80]) for inner, _ in entries(entry)] if os.path.isdir(entry) else []
    except BadPath as closed:
        return f" ({closed})"
    more = ", ..." if len(names) > MOST_NAMES else ""
    return f" (it holds {', '.join(names[:MOST_NAMES])}{more})" if names else ""


def _shown(entry: Path) -> str:
    return printable("/".join(entry.parts[-2:]))


def not_handed_in(path: Path, work: Sequence[Submission], folders: Iterable[Path]) -> list[Submission]:
    """Return a submission without a file for each student on the roster and assignment that only others handed in.

    There is none if `collect` lists a file that may be the student's: it could not be placed, or has the same name.
    """
    here = {submission.key for submission in work}
    students = roster.students(path, {submission.student for submission in work})
    slugs = sorted({submission.slug for submission in work})
    message = "no module or notebook was collected"
    names, rows = roster.names(path), [row for folder in folders for row in _collected(folder)]
    here |= {(row["student"], row["assignment"]) for row in rows if not row["file"]}
    strange = {(roster.letters(row["name"]), row["assignment"]) for row in rows if row["student"] not in students}
    absent = [pair for pair in product(students, slugs) if pair not in here]
    return [
        Submission(student, slug, None, Path(), message)
        for student, slug in absent
        if student not in names or (roster.letters(names[student]), slug) not in strange
    ]
