"""Rows of points by hand as an instructor writes them: checked, or written as a template."""

import difflib
from collections.abc import Iterator, Mapping
from pathlib import Path

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

__all__ = ["checked_rows", "write_template"]

NEED_A_REASON = (ADJUST, TOTAL, EXCUSED)  # and a check
Manual = Mapping[str, tuple[float, str]]  # part: points given by hand, and for what
Rubric = Mapping[str, ManualPart]  # by part
Checks = Mapping[str, float]  # check: its points


def checked_rows(
    path: Path, found: Results, manual: Mapping[str, Manual], checks: Mapping[str, Checks]
) -> Iterator[Entry]:
    """The entries of a table, each part with its most; UsageError for the first row that is wrong."""
    from tam570_grader.checks.assignments import slug_of

    students = {student for student, _ in found} | {EVERYONE}
    touched = set()
    for line, one in manual_points.rows_of(path):
        if one.slug == EVERYONE and one.item in OF_THE_TERM:
            if one.student not in students:
                raise UsageError(f"{path}, line {line}: there are no results of a student {one.student!r}")
            yield one
            continue
        slug = slug_of(one.slug, [*manual])
        if slug is None:
            raise UsageError(f"{path}, line {line}: there are no results of an assignment {one.slug!r}")
        parts = manual[slug]
        if wrong := _wrong(one, students, parts, checks.get(slug, {})):
            raise UsageError(f"{path}, line {line}: {wrong}")
        of = parts[one.item][0] if one.item in parts else None
        touched |= {slug} if of is not None else set()
        yield Entry(one.student, slug, one.item, one.points, of, one.comment)
    for slug in sorted(touched):  # everybody is graded out of the same
        yield from (Entry(EVERYONE, slug, part, None, of) for part, (of, _) in manual[slug].items())


def _wrong(one: Entry, students: set[str], parts: Manual, checks: Checks) -> str:
    """What is wrong with a row, and the remedy; empty if nothing is."""
    letters = ", ".join(parts) or "none"
    if one.student not in students:
        return f"there are no results of a student {one.student!r}; write the name of the folder that was graded"
    if one.item not in (*parts, *checks, *WORDS):
        near = difflib.get_close_matches(one.item, checks, 1)
        rest = f"do you mean the check {near[0]}?" if near else f"the others: {', '.join(WORDS)}, names of checks"
        return f"there is no item {one.item!r}; the parts graded by hand are {letters}, {rest}"
    if one.points is None:
        return ""
    if one.item in checks and not 0 <= one.points <= checks[one.item]:
        return f"{one.item} has from 0 to {checks[one.item]:g} points, not {one.points:g}; use adjust for more"
    if one.item in parts and not 0 <= one.points <= parts[one.item][0]:
        return f"part ({one.item}) has from 0 to {parts[one.item][0]:g} points, not {one.points:g}; use adjust for more"
    if one.item in parts and one.student == EVERYONE:
        return "the points of a part are one student's; write a name, or adjust everybody's"
    if one.item in (TOTAL, LATE, EXTENSION) and one.points < 0 or one.item in (OFF, MOST) and not 0 <= one.points <= 1:
        remedy = "a share from 0 to 1" if one.item in (OFF, MOST) else "no negative number"
        return f"{one.item} is {one.points:g}; write {remedy}"
    if one.item in (*NEED_A_REASON, *checks) and not one.comment:
        return f"{one.item} needs a reason, in the column comment: the student reads it"
    return ""


def write_template(path: Path, found: Results, rubrics: Mapping[str, Rubric], hand: ManualAdjustments) -> int:
    """Write a table with a row for each student and part, beside the claims; what is known is filled in."""
    if path.exists():
        raise UsageError(f"{path} is there already, and may hold points that you typed; name a new file")
    rows: list[tuple[object, ...]] = [(*COLUMNS, "claims")]  # the last is for the eye: it is not read back
    for student, slug in found:
        for part, rubric in rubrics.get(slug, {}).items():
            known = hand.entries.get((student, slug, part))
            points = "" if known is None or known.points is None else known.points
            comment = known.comment if known else ""
            rows.append((student, slug, part, points, f"{rubric.points:g}", comment, rubric.line))
    with writing(path):
        write_table(path, rows)
    say(f"{path}: fill in the points, then: tam570-grader points DIR {path}")
    return 0
