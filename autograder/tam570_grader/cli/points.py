"""The command that takes points by hand: `tam570-grader points`."""

import argparse
import contextlib
from pathlib import Path

from tam570_grader.checks import assignments
from tam570_grader.course import course_config, late_policy
from tam570_grader.errors import UsageError, counted, say, warn, writing
from tam570_grader.lms.points import checked_rows, write_template
from tam570_grader.reports import feedback
from tam570_grader.results import manual_points
from tam570_grader.results.manual_points import COLUMNS, EVERYONE, LATE
from tam570_grader.results.store import ResultStore, results


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
    add(
        "table", type=Path, nargs="?", metavar="CSV", help=f"the columns are {', '.join(COLUMNS)}; `of` may be left out"
    )
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
            return write_template(arguments.table, graded, rubrics, manual_points.read(folder))
        new = list(checked_rows(arguments.table, graded, rubrics, checks)) if arguments.table else []
    feedback.must_write_pages()
    with writing(folder), contextlib.closing(ResultStore(folder)) as store:  # nobody else adds rows meanwhile
        adjustments, open_, notes = late_policy.apply_late_policy(
            manual_points.read(folder).with_(new), policies, store, arguments.collected
        )
        manual_points.write(folder, adjustments)
        failed = feedback.write_pages(folder / "feedback", store, course)
    for line in [*open_, *notes]:
        warn(line)
    count = sum(entry.item == LATE for entry in adjustments.entries.values())
    rows = counted(len({entry.key for entry in new if entry.student != EVERYONE}), "row")
    say(f"{folder}: {rows} added by hand, {count} late")
    return 1 if open_ or failed else 0
