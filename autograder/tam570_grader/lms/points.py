"""Rows of points by hand as an instructor writes them: checked, or written as a template."""

import difflib
from collections.abc import Iterator, Mapping
from pathlib import Path

from tam570_grader.checks.assignments import slug_of
from tam570_grader.checks.rubric import ManualPart
from tam570_grader.errors import UsageError, say, writing
from tam570_grader.results import manual_points
from tam570_grader.results.manual_points import (
    ADJUST,
    COLUMNS,
    EVERYONE,
    EXCUSED,
    EXTENSION,
    LATE,
    MOST,
    OF_THE_TERM,
    OFF,
    TOTAL,
    WORDS,
    Entry,
    ManualAdjustments,
)
from tam570_grader.results.store import Results
from tam570_grader.results.tables import write_table

NEED_A_REASON = (ADJUST, TOTAL, EXCUSED)  # and a check
Rubric = Mapping[str, ManualPart]  # by part
Checks = Mapping[str, float]  # check: its points


def checked_rows(
    path: Path, results: Results, rubrics: Mapping[str, Rubric], checks: Mapping[str, Checks]
) -> Iterator[Entry]:
    """Yield the entries of a table, each part with its most; UsageError for the first row that is wrong."""
    students = {student for student, _ in results} | {EVERYONE}
    touched = set()
    for line, entry in manual_points.rows_of(path):
        if entry.slug == EVERYONE and entry.item in OF_THE_TERM:
            if entry.student not in students:
                raise UsageError(f"{path}, line {line}: there are no results of a student {entry.student!r}")
            yield entry
            continue
        slug = slug_of(entry.slug, [*rubrics])
        if slug is None:
            raise UsageError(f"{path}, line {line}: there are no results of an assignment {entry.slug!r}")
        parts = rubrics[slug]
        if wrong := _wrong(entry, students, parts, checks.get(slug, {})):
            raise UsageError(f"{path}, line {line}: {wrong}")
        of = parts[entry.item].points if entry.item in parts else None
        touched |= {slug} if of is not None else set()
        yield Entry(entry.student, slug, entry.item, entry.points, of, entry.comment)
    for slug in sorted(touched):  # everybody is graded out of the same
        yield from (Entry(EVERYONE, slug, part, None, manual.points) for part, manual in rubrics[slug].items())


def _wrong(entry: Entry, students: set[str], parts: Rubric, checks: Checks) -> str:
    """Return what is wrong with a row, and the remedy; empty if nothing is."""
    letters = ", ".join(parts) or "none"
    if entry.student not in students:
        return f"there are no results of a student {entry.student!r}; write the name of the folder that was graded"
    if entry.item not in (*parts, *checks, *WORDS):
        near = difflib.get_close_matches(entry.item, checks, 1)
        rest = f"do you mean the check {near[0]}?" if near else f"the others: {', '.join(WORDS)}, names of checks"
        return f"there is no item {entry.item!r}; the parts graded by hand are {letters}, {rest}"
    if entry.points is None:
        return ""
    if entry.item in checks and not 0 <= entry.points <= checks[entry.item]:
        return f"{entry.item} has from 0 to {checks[entry.item]:g} points, not {entry.points:g}; use adjust for more"
    if entry.item in parts and not 0 <= entry.points <= (most := parts[entry.item].points):
        return f"part ({entry.item}) has from 0 to {most:g} points, not {entry.points:g}; use adjust for more"
    if entry.item in parts and entry.student == EVERYONE:
        return "the points of a part are one student's; write a name, or adjust everybody's"
    if (
        entry.item in (TOTAL, LATE, EXTENSION)
        and entry.points < 0
        or entry.item in (OFF, MOST)
        and not 0 <= entry.points <= 1
    ):
        remedy = "a share from 0 to 1" if entry.item in (OFF, MOST) else "no negative number"
        return f"{entry.item} is {entry.points:g}; write {remedy}"
    if entry.item in (*NEED_A_REASON, *checks) and not entry.comment:
        return f"{entry.item} needs a reason, in the column comment: the student reads it"
    return ""


def write_template(path: Path, results: Results, rubrics: Mapping[str, Rubric], adjustments: ManualAdjustments) -> int:
    """Write a table with a row for each student and part, beside the claims; what is known is filled in."""
    if path.exists():
        raise UsageError(f"{path} is there already, and may hold points that you typed; name a new file")
    rows: list[tuple[object, ...]] = [(*COLUMNS, "claims")]  # the last is for the eye: it is not read back
    for student, slug in results:
        for part, rubric in rubrics.get(slug, {}).items():
            entry = adjustments.entries.get((student, slug, part))
            points = "" if entry is None or entry.points is None else entry.points
            comment = entry.comment if entry else ""
            rows.append((student, slug, part, points, f"{rubric.points:g}", comment, rubric.line))
    with writing(path):
        write_table(path, rows)
    say(f"{path}: fill in the points, then: tam570-grader points DIR {path}")
    return 0
