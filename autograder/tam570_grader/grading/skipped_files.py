"""Nobody vanishes: what lies in a class's folder and is not graded is named, and who handed in nothing gets a row."""

import os
from collections.abc import Collection, Iterable, Iterator, Sequence
from pathlib import Path

from tam570_grader.checks.assignments import slug_of
from tam570_grader.errors import printable
from tam570_grader.grading import roster
from tam570_grader.grading.submissions import GIVEN, MOST_NAMES, BadPath, Submission, entries, holds_students, of_name
from tam570_grader.results.collected import form

__all__ = ["not_handed_in", "skipped_files"]

PACKED = (".zip", ".txt", ".gz", ".7z", ".rar", ".tar")  # forms in which work is handed in by mistake
REMEDY = "name it after its assignment, as hw08.py, or name the assignment with --assignment"


def skipped_files(
    paths: Iterable[Path], found: Sequence[Submission], known: Sequence[str], students: Collection[str] = ()
) -> Iterator[str]:
    """Yield a sentence for everything at these paths that no submission accounts for; it names the remedy.

    students : names of folders that are students', by a roster
    """
    trees, graded = {one.tree for one in found}, {one.path for one in found}
    for folder in paths:
        if not folder.is_dir() or folder.resolve() in trees:
            continue
        is_class = holds_students(folder.absolute(), known, students)
        for entry, is_folder in entries(folder.absolute()):
            is_students = is_folder and (is_class or not slug_of(entry.name, known))
            if entry in trees and is_students:
                yield from _beside(entry, graded, known)
            elif entry not in trees and entry not in graded and (is_students or not _names_another(entry, known)):
                yield f"{_shown(entry)}{_holding(entry)} is not graded: no name in it tells the assignment; {REMEDY}"


def _beside(own: Path, graded: set[Path | None], known: Sequence[str]) -> Iterator[str]:
    """Yield what else a student's own folder holds that could be work."""
    try:
        held = entries(own)
    except BadPath:  # it has a row that says so
        return
    for entry, is_folder in held:
        if entry in graded or GIVEN.fullmatch(entry.stem) or _names_another(entry, known):
            continue
        if is_folder or form(entry.name) or entry.suffix.lower() in PACKED:
            yield f"{_shown(entry)} is not graded; {REMEDY}"


def _names_another(entry: Path, known: Sequence[str]) -> bool:
    """Return whether it is work on an assignment that was not asked for, or that has a row."""
    return bool(
        slug_of(entry.name, known) or (not os.path.isdir(entry) and form(entry.name) and of_name(entry.name, known))
    )


def _holding(entry: Path) -> str:
    """Return the first files of a folder, in brackets."""
    try:
        names = [printable(one.name[:80]) for one, _ in entries(entry)] if os.path.isdir(entry) else []
    except BadPath as closed:
        return f" ({closed})"
    more = ", ..." if len(names) > MOST_NAMES else ""
    return f" (it holds {', '.join(names[:MOST_NAMES])}{more})" if names else ""


def _shown(entry: Path) -> str:
    return printable("/".join(entry.parts[-2:]))


def not_handed_in(path: Path, found: Sequence[Submission]) -> list[Submission]:
    """Return a row without a file for everyone on the roster, for each assignment that others have handed in."""
    here = {(one.student, one.slug) for one in found}
    students = roster.students(path, {one.student for one in found})
    slugs = sorted({one.slug for one in found})
    note = "no module or notebook was collected"
    return [
        Submission(student, slug, None, Path(), note)
        for student in students
        for slug in slugs
        if (student, slug) not in here
    ]
