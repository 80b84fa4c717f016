"""The command that takes points by hand, `tam570-grader points`: checks rows, brings tables and pages up to date."""

import argparse
import contextlib
import difflib
from collections.abc import Iterator, Mapping
from pathlib import Path

from tam570_grader.errors import UsageError, counted, say, warn, writing
from tam570_grader.options import Commands
from tam570_grader.release import late_policy
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
from tam570_grader.results.store import Results, ResultStore, results
from tam570_grader.results.tables import write_table
from tam570_grader.rubric import ManualPart

__all__ = ["add_points"]

NEED_A_REASON = (ADJUST, TOTAL, EXCUSED)  # and a check
Manual = Mapping[str, tuple[float, str]]  # part: points given by hand, and for what
Rubric = Mapping[str, ManualPart]  # by part
Checks = Mapping[str, float]  # check: its points


def add_points(commands: Commands) -> argparse.ArgumentParser:
    points: argparse.ArgumentParser = commands.add_parser(
        "points",
        help="add points by hand, late days and changes to results",
        description="Add what a table says to the results: grades.csv, the pages, the report and lms have it then. "
        "An item is the letter of a part that is graded by hand, the name of a check, or a word. A check gets these "
        "points in the place of its own. With adjust points are added, and total stands in the place of the score. "
        "All three need a comment. late and extension count days. 'off a day' is the "
        "share of the score that a late day costs, 'most off' the largest share. The student * is everybody.",
        epilog="The newest row of a student, an assignment and an item counts; one without points takes it back. "
        "Nothing is written unless every row is right. DIR/by_hand.csv holds all of it. course.toml may say what late "
        "days cost, when assignments are due, and who has more time: give the command again when it changes.",
    )
    points.set_defaults(command=_points)
    add = points.add_argument
    add("folder", type=Path, metavar="DIR", help="what `grade --out` wrote")
    add(
        "table", type=Path, nargs="?", metavar="CSV", help=f"the columns are {', '.join(COLUMNS)}; `of` may be left out"
    )
    add(
        "--template",
        action="store_true",
        help="write the table to fill in, with what is known, to CSV instead, a new file",
    )
    times = "collected.csv, which `collect` wrote: who is late by the dates in course.toml"
    add("--collected", type=Path, metavar="CSV", help=times)
    return points


def _points(arguments: argparse.Namespace) -> int:
    from tam570_grader.checks import assignments
    from tam570_grader.release import course_config
    from tam570_grader.reports import feedback

    course, folder = course_config.course_of(arguments), arguments.folder
    if not (folder / "results.jsonl").is_file():
        raise UsageError(f"there are no results in {folder}; make them with: tam570-grader grade ... --out {folder}")
    with contextlib.closing(results(folder)) as found:
        slugs = sorted({slug for _, slug in found})
        known = assignments.slugs(course)
        here = {slug: assignments.assignment(course, slug) for slug in slugs if slug in known}
        manual = {slug: here[slug].manual if slug in here else {} for slug in slugs}
        checks = {slug: {check.name: check.points for check in one.checks} for slug, one in here.items()}
        terms = late_policy.policies_of(course)
        if not arguments.table and (arguments.template or not (terms or arguments.collected)):
            raise UsageError("name the table, too: tam570-grader points DIR CSV")
        if arguments.template:
            rubrics = {slug: one.rubric for slug, one in here.items()}
            return _template(arguments.table, found, rubrics, manual_points.read(folder))
        new = list(_checked(arguments.table, found, manual, checks)) if arguments.table else []
    feedback.must_write_pages()
    with contextlib.closing(ResultStore(folder)) as book:  # nobody else adds rows meanwhile
        hand, open_, notes = late_policy.apply_late_policy(
            manual_points.read(folder).with_(new), terms, book, arguments.collected
        )
        manual_points.write(folder, hand)
        failed = feedback.write_pages(folder / "feedback", book, course)
    for line in [*open_, *notes]:
        warn(line)
    count = sum(one.item == LATE for one in hand.entries.values())
    rows = counted(len({one.key for one in new if one.student != EVERYONE}), "row")
    say(f"{folder}: {rows} added by hand, {count} late")
    return 1 if open_ or failed else 0


def _checked(path: Path, found: Results, manual: Mapping[str, Manual], checks: Mapping[str, Checks]) -> Iterator[Entry]:
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


def _template(path: Path, found: Results, rubrics: Mapping[str, Rubric], hand: ManualAdjustments) -> int:
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
