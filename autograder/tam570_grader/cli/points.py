"""The command `tam570-grader points`, which adds points by hand to results."""

import argparse
import contextlib
import difflib
import shlex
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path

from tam570_grader.checks import assignments
from tam570_grader.checks.rubric import ManualPart
from tam570_grader.course import course_config, late_policy
from tam570_grader.errors import UsageError, counted, say, warn, writing
from tam570_grader.reports import feedback
from tam570_grader.results import manual_points
from tam570_grader.results.manual_points import COLUMNS, EVERYONE, LATE, TOTAL, WORDS, Entry, ManualAdjustments
from tam570_grader.results.store import Results, ResultStore, results
from tam570_grader.results.tables import write_table

NEED_A_REASON = (manual_points.ADJUST, TOTAL, manual_points.EXCUSED)  # as does a check
NOT_NEGATIVE, SHARES = (TOTAL, LATE, manual_points.EXTENSION), (manual_points.OFF, manual_points.MOST)
Rubric = Mapping[str, ManualPart]  # by part
Checks = Mapping[str, float]  # points by check


def add_points(parser: argparse.ArgumentParser) -> None:
    """Add the options of `points`."""
    parser.set_defaults(command=_points)
    parser.description = (
        "Add a table of points to the results; grades.csv, the pages, the report and lms use it from then on. "
        "An item is the letter of a part that you grade by hand, the name of a check, or a word. The points of a check "
        "replace its own; 'adjust' adds points; 'total' replaces the score. "
        "All three need a comment. 'late' and 'extension' count days. 'off a day' is the "
        "share of the score that a late day costs, 'most off' the largest share. A row for student * applies to "
        "everyone who has no row."
    )
    parser.epilog = (
        "The newest row of a student, an assignment and an item counts; one without points takes it back. "
        "Nothing is written unless every row is right. DIR/by_hand.csv holds all of it. course.toml may set what late "
        "days cost, when assignments are due, and who has more time; run the command again when it changes."
    )
    add = parser.add_argument
    add("folder", type=Path, metavar="DIR", help="what `grade --out` wrote")
    columns = f"the columns are {', '.join(COLUMNS)}; `of` may be left out"
    add("table", type=Path, nargs="?", metavar="CSV", help=columns)
    add("--template", action="store_true", help="write a table to fill in to CSV, a new file, with the points so far")
    times = "collected.csv, which `collect` wrote, to find who is late by the dates in course.toml"
    add("--collected", type=Path, metavar="CSV", help=times)


def _points(arguments: argparse.Namespace) -> int:
    course, folder = course_config.course_of(arguments.root), arguments.folder
    with contextlib.closing(results(folder)) as graded:
        slugs = sorted({slug for _, slug in graded})
        offered = assignments.slugs(course)
        here = {slug: assignments.assignment(course, slug) for slug in slugs if slug in offered}
        rubrics = {slug: here[slug].rubric if slug in here else {} for slug in slugs}
        checks = {slug: {check.name: check.points for check in assignment.checks} for slug, assignment in here.items()}
        policies = late_policy.policies_of(course)
        if not arguments.table and (arguments.template or not (policies or arguments.collected)):
            raise UsageError("name the table, too: tam570-grader points DIR CSV")
        if arguments.template:
            return _write_template(folder, arguments.table, graded, rubrics)
        new = list(_checked_rows(arguments.table, graded, rubrics, checks)) if arguments.table else []
    feedback.must_write_pages()
    with writing(folder), contextlib.closing(ResultStore(folder)) as store:  # locked: no other command adds rows
        old = manual_points.read(folder)
        manual = old.with_(new)
        adjustments, open_, notes = late_policy.apply_late_policy(manual, policies, store, arguments.collected)
        notes += _taken_back(old, new)
        if free := sorted({entry.slug for entry in new if entry.item == LATE and adjustments.is_late_free(entry)}):
            notes.append(
                f"Late days in {', '.join(free)} cost nothing; add a row '{manual_points.OFF}' with their cost."
            )
        manual_points.write(folder, adjustments)
        failed = feedback.write_pages(folder / "feedback", store, course)
    for line in [*open_, *notes]:
        warn(line)
    count = sum(entry.item == LATE for entry in adjustments.entries.values())
    rows = counted(len({entry.key for entry in new if entry.student != EVERYONE}), "row")
    say(f"{folder}: {rows} added by hand, {count} late")
    return 1 if open_ or failed else 0


def _taken_back(old: ManualAdjustments, new: Iterable[Entry]) -> Iterator[str]:
    """Yield a sentence for each row that had points and has none now, as in a template filled by somebody else."""
    for entry in new:
        earlier = old.entries.get(entry.key)
        if entry.points is None and earlier and earlier.points is not None:
            what = f"{entry.item} of {entry.student} in {entry.slug}"
            yield f"{what} had {earlier.points:g}; a row without points took it back"


def _checked_rows(
    path: Path, results: Results, rubrics: Mapping[str, Rubric], checks: Mapping[str, Checks]
) -> Iterator[Entry]:
    """Yield the entries of a table, parts with their maximum points; raise UsageError for the first invalid row."""
    students = {student for student, _ in results} | {EVERYONE}
    touched = set()
    for line, entry in manual_points.rows_of(path):
        if entry.slug == EVERYONE and entry.item in manual_points.OF_THE_TERM:
            if entry.student not in students:
                raise UsageError(f"{path}, line {line}: there are no results of a student {entry.student!r}")
            yield entry
            continue
        slug = assignments.slug_of(entry.slug, [*rubrics])
        if slug is None:
            raise UsageError(f"{path}, line {line}: there are no results of an assignment {entry.slug!r}")
        parts = rubrics[slug]
        if wrong := _wrong(entry, students, parts, checks.get(slug, {})):
            raise UsageError(f"{path}, line {line}: {wrong}")
        of = parts[entry.item].points if entry.item in parts else None
        touched |= {slug} if of is not None else set()
        yield Entry(entry.student, slug, entry.item, entry.points, of, entry.comment)
    for slug in sorted(touched):  # everyone's maximum score then includes the parts
        yield from (Entry(EVERYONE, slug, part, None, manual.points) for part, manual in rubrics[slug].items())


def _wrong(entry: Entry, students: set[str], parts: Rubric, checks: Checks) -> str:
    """Return what is wrong with a row, and the remedy; "" if the row is valid."""
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
    if entry.item in NOT_NEGATIVE and entry.points < 0:
        return f"{entry.item} is {entry.points:g}; write no negative number"
    if entry.item in SHARES and not 0 <= entry.points <= 1:
        return f"{entry.item} is {entry.points:g}; write a share from 0 to 1"
    if entry.item in (*NEED_A_REASON, *checks) and not entry.comment:
        return f"{entry.item} needs a reason, in the column comment: the student reads it"
    return ""


def _write_template(folder: Path, path: Path, results: Results, rubrics: Mapping[str, Rubric]) -> int:
    """Write a table with a row for each student and part, with points so far and claims; return the exit code."""
    if path.exists():
        raise UsageError(f"{path} is there already, and may hold points that you typed; name a new file")
    if not any(rubrics.values()):
        raise UsageError(f"no assignment in {folder} has a part that is graded by hand")
    adjustments = manual_points.read(folder)
    rows: list[tuple[object, ...]] = [(*COLUMNS, "claims")]  # claims are for the reader only
    for student, slug in results:
        for part, rubric in rubrics.get(slug, {}).items():
            entry = adjustments.entries.get((student, slug, part))
            points = "" if entry is None or entry.points is None else entry.points
            comment = entry.comment if entry else ""
            rows.append((student, slug, part, points, f"{rubric.points:g}", comment, rubric.line))
    with writing(path):
        write_table(path, rows)
    say(f"{path}: fill in the points, then: tam570-grader points {shlex.join([str(folder), str(path)])}")
    return 0
