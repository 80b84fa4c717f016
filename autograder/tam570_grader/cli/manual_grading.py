"""The command `tam570-grader mark`, which serves pages to grade parts by hand."""

import argparse
import contextlib
from pathlib import Path

from tam570_grader.checks import assignments
from tam570_grader.cli.options import natural
from tam570_grader.course import course_config
from tam570_grader.errors import UsageError, say, writing
from tam570_grader.grading.submissions import submissions
from tam570_grader.lms.manual_grading import Desk, StudentWork, serve
from tam570_grader.reports import feedback
from tam570_grader.results import manual_points
from tam570_grader.results.store import ResultStore, results


def add_mark(parser: argparse.ArgumentParser) -> None:
    """Add the options of `mark`."""
    parser.set_defaults(command=_mark)
    parser.description = (
        "Open a page on this machine with each student's work beside the claims of the rubric. It writes "
        "the points and comments into DIR/by_hand.csv, as `points` does."
    )
    parser.epilog = (
        "The address holds a secret: give it to nobody. Keys: n and p change the student, 1 to 9 tick claims."
    )
    add = parser.add_argument
    add("folder", type=Path, metavar="DIR", help="what `grade --out` wrote")
    add("--submitted", type=Path, metavar="DIR", help="the tree of submissions, to show the work")
    add("--only", nargs="+", metavar="SLUG", default=[], help="show only these assignments")
    add("--anonymous", action="store_true", help="show numbers for names, in any order")
    add("--port", type=natural, default=0, help="the port of the page (default: any free one)")


def _mark(arguments: argparse.Namespace) -> int:
    tree = [arguments.submitted] if arguments.submitted else []
    course, folder = course_config.course_of(arguments.root, tree), arguments.folder
    feedback.must_write_pages()
    slugs = assignments.slugs(course)
    with contextlib.closing(results(folder)) as graded:
        keys = sorted((record["assignment"], record["student"]) for record in graded.values())
    chosen = assignments.match_slugs(arguments.only, sorted({slug for slug, _ in keys}))
    rubrics = {slug: assignments.assignment(course, slug).rubric for slug in chosen if slug in slugs}
    by_key = {submission.key: submission for submission in submissions(tree, slugs)}
    works = [StudentWork(who, slug, rubrics[slug], by_key.get((who, slug))) for slug, who in keys if rubrics.get(slug)]
    if not works:
        raise UsageError(f"no assignment in {folder} has a part that is graded by hand")
    server, address = serve(Desk(folder, works, anonymous=arguments.anonymous), arguments.port)
    say(f"open {address}\nCtrl-C ends it; what you gave is in {folder / manual_points.FILE}")
    try:
        server.serve_forever()
    except KeyboardInterrupt:
        pass
    finally:
        server.server_close()
    with writing(folder), contextlib.closing(ResultStore(folder)) as store:
        feedback.write_pages(folder / "feedback", store, course)
    return 0
