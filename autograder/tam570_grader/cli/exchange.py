"""The commands that import submissions, and export scores, pages and copies of submissions."""

import argparse
import contextlib
from collections.abc import Iterable, Sequence
from functools import partial
from pathlib import Path

from tam570.values import Json
from tam570_grader.checks import assignments
from tam570_grader.course import course_config, course_toml, late_policy
from tam570_grader.errors import UsageError, warn
from tam570_grader.grading import roster
from tam570_grader.lms import feedback_export, score_export, similarity, similarity_export, submission_import
from tam570_grader.lms.hand_ins import hand_ins
from tam570_grader.lms.systems import SYSTEMS
from tam570_grader.reports import feedback
from tam570_grader.results import manual_points
from tam570_grader.results.store import results


def _titles(names: Iterable[str]) -> str:
    *first, last = (SYSTEMS[name].title for name in names)
    return f"{', '.join(first)} or {last}"


def add_collect(parser: argparse.ArgumentParser) -> None:
    """Add the options of `collect`."""
    parser.set_defaults(command=_collect)
    parser.description = (
        f"Put a download of {_titles(SYSTEMS)} into folders <student>/<assignment>/ that `grade` reads. A "
        "download is of one assignment. If a student uploaded several files, `collect` keeps one: a module before a "
        "notebook, the one named after the assignment before others, else the newest."
    )
    parser.epilog = (
        "collected.csv, beside that folder, lists who handed in what and when, in all downloads. The exit code "
        "is 1 if `collect` cannot place a file or its student, or skips a newer file; it names each."
    )
    add = parser.add_argument
    add("source", type=Path, metavar="ZIP", help="the zip file that you downloaded, or its folder")
    add("--from", dest="system", choices=[*SYSTEMS], required=True, help="the system")
    add("--roster", type=Path, metavar="CSV", help="the gradebook or participants: folders are named by login")
    add("--groups", type=Path, metavar="CSV", help="who is in which group: columns group, and login or another id")
    add("--times", type=Path, metavar="CSV", help="when work came: Moodle's grading worksheet or log")
    add("--assignment", metavar="SLUG", help="the assignment, if no name of a file tells it")
    add("--to", type=Path, metavar="DIR", default=Path("submitted"), help="default: %(default)s")


def add_export(parser: argparse.ArgumentParser) -> None:
    """Add the options of `export`."""
    parser.set_defaults(command=_export)
    parser.description = (
        "Copy submissions into the folders of a tool that finds shared code. Numbers replace names; notebooks "
        "become modules; the tool ignores the code that you released."
    )
    parser.epilog = "Keep names.csv, which lists the student of each number. Names in a student's own text stay."
    add = parser.add_argument
    add("paths", nargs="+", type=Path, metavar="PATH", help="what `grade` is given")
    add("--for", dest="tool", choices=["dolos", "jplag", "moss"], required=True, help="the tool")
    add("--to", type=Path, metavar="DIR", required=True, help="a folder that is new or empty")
    add("--assignment", metavar="SLUG", help="the assignment, if no name tells it")


def add_alike(parser: argparse.ArgumentParser) -> None:
    """Add the options of `alike`."""
    parser.set_defaults(command=_alike)
    parser.description = (
        "List pairs of submissions that share code, most alike first. It ignores names, comments and "
        "what you released. The number of each student is the share of their code that the other one has, too."
    )
    parser.epilog = (
        "Short assignments have few right ways: look at both before you ask anybody. `report` lists who share "
        "a wrong result."
    )
    add = parser.add_argument
    add("paths", nargs="+", type=Path, metavar="PATH", help="what `grade` is given")
    add("--least", type=_share, metavar="SHARE", default=0.6, help="the smallest share to list (default: %(default)s)")
    add("--assignment", metavar="SLUG", help="the assignment, if no name tells it")


def add_lms(parser: argparse.ArgumentParser) -> None:
    """Add the options of `lms`."""
    importing = [name for name, system in SYSTEMS.items() if system.table]
    parser.set_defaults(command=_lms)
    parser.description = (
        f"Make a table of scores that {_titles(importing)} imports, and a zip file of pages that some of "
        "them hand out. Columns of the gradebook stay as they are; course.toml says which one an assignment has."
    )
    parser.epilog = (
        "With a roster the exit code is 1 if a score belongs to nobody on it, or somebody on it has none, if a "
        "score was changed in the gradebook, or if nobody graded a part by hand."
    )
    add = parser.add_argument
    add("grades", type=Path, metavar="GRADES", help="what `grade --out` wrote, or the table of `nbgrader export`")
    add("--to", choices=importing, required=True, help="the system")
    add("--roster", type=Path, metavar="FILE", help="the gradebook or participants that the system exported")
    add("--identity", choices=["username", "idnumber", "email"], default="username", help="Moodle's column of students")
    add("--only", nargs="+", metavar="SLUG", default=[], help="write only these assignments")
    absent = "the score of students who handed in nothing where others did (default: %(default)s)"
    add("--absent", choices=["zero", "blank"], default="zero", help=absent)
    ungraded = "for parts by hand that nobody graded: stop, or give no points (default: %(default)s)"
    add("--ungraded", choices=["stop", "zero"], default="stop", help=ungraded)
    add("--new", action="store_true", help="make columns that the gradebook does not have")
    add("--overwrite", action="store_true", help="replace scores that were changed in the gradebook")
    add("--pages", type=Path, metavar="ZIP", help="also a zip file of one assignment's pages, to hand back there")
    add("--collected", type=Path, metavar="CSV", help="for --pages: collected.csv, which `collect` wrote")
    add("--out", type=Path, metavar="FILE", help="default: print it")


def add_report(parser: argparse.ArgumentParser) -> None:
    """Add the options of `report`."""
    parser.set_defaults(command=_report)
    parser.description = "Make one page on the class: scores, checks, known mistakes, who is missing."
    add = parser.add_argument
    add("folder", type=Path, metavar="DIR", help="what `grade --out` wrote")
    add("--roster", type=Path, metavar="FILE", help="all students, one a line or in the first column of a table")
    add("--collected", type=Path, metavar="CSV", help="collected.csv, which `collect` wrote: when and how often")
    add("--out", type=Path, metavar="FILE", help="default: DIR/report.html, beside the feedback it links to")


def _collect(arguments: argparse.Namespace) -> int:
    _, slugs, slug = _course_and_slug(arguments, [arguments.source, arguments.to])
    lists = submission_import.Lists(arguments.roster, arguments.groups, arguments.times)
    return submission_import.run(arguments.source, arguments.system, arguments.to, slugs, slug, lists)


def _export(arguments: argparse.Namespace) -> int:
    course, slugs, slug = _course_and_slug(arguments, arguments.paths)
    return similarity_export.run(course, arguments.paths, arguments.tool, arguments.to, slugs, slug)


def _share(text: str) -> float:
    try:
        share = float(text)
    except ValueError:
        share = -1.0
    if not 0 <= share <= 1:
        raise argparse.ArgumentTypeError(f"{text!r} is not a share from 0 to 1")
    return share


def _alike(arguments: argparse.Namespace) -> int:
    course, slugs, slug = _course_and_slug(arguments, arguments.paths)
    return similarity.run(course, arguments.paths, slugs, slug, arguments.least)


def _lms(arguments: argparse.Namespace) -> int:
    course = course_config.course_of(arguments.root)
    grades = arguments.grades / "grades.csv" if arguments.grades.is_dir() else arguments.grades
    if bool(arguments.pages) != bool(arguments.collected):
        raise UsageError("--pages and --collected go together: the names of the download tell whose a page is")
    stale, ungraded = _open_questions(grades.parent, course, arguments.only)
    if ungraded and arguments.ungraded == "stop":
        for line in ungraded:
            warn(line)
        return 1
    lacking = []
    if arguments.pages:
        pages = grades.parent / "feedback"
        names = arguments.collected, arguments.to, arguments.pages, arguments.only, arguments.roster
        lacking = feedback_export.run(pages, *names)
    for line in filter(None, [*lacking, stale]):
        warn(line)
    chosen: Json = {name: vars(arguments)[name] for name in ("roster", "identity", "new", "overwrite")}
    columns = course_toml.columns(course, arguments.to)
    options = score_export.ExportOptions(arguments.to, columns=columns, **chosen)
    code = score_export.run(grades, arguments.out, options, arguments.only, arguments.absent)
    return code or bool(lacking)


def _open_questions(folder: Path, course: Path, only: Sequence[str] = ()) -> tuple[str, list[str]]:
    """Return a warning if course.toml has another late policy than the results, else ""; and ungraded parts.

    These are sentences, one for each part that is graded by hand and still lacks points of students with results.
    """
    if not (folder / "results.jsonl").is_file():  # for example nbgrader's table, which formgrader fills
        return "", []
    adjustments, slugs, lines = manual_points.read(folder), assignments.slugs(course), []
    with contextlib.closing(results(folder)) as graded:
        stale = late_policy.stale(folder, adjustments, course, {slug for _, slug in graded})
        here = [key for key, line in sorted(graded.lines.items()) if line.graded.status != "missing"]
    for slug in assignments.match_slugs(only, sorted({slug for _, slug in here})):
        for part in assignments.rubric_of(course, slug) if slug in slugs else ():
            waiting = [key[0] for key in here if key[1] == slug and adjustments.is_missing(key, part)]
            if waiting:
                everybody = "nobody has" if len(waiting) == sum(which == slug for _, which in here) else "these lack"
                names = ", ".join(waiting[:5]) + (", ..." if len(waiting) > 5 else "")
                lines.append(
                    f"{everybody} points of part ({part}) of {slug} by hand: {names}; use points, or --ungraded zero"
                )
    return stale, lines


def _report(arguments: argparse.Namespace) -> int:
    from tam570_grader.reports import report  # imported late: it loads Matplotlib

    feedback.must_write_pages()
    course = course_config.course_of(arguments.root)
    stale, _ = _open_questions(arguments.folder, course)
    if stale:
        warn(stale)
    everyone = partial(roster.students, arguments.roster) if arguments.roster else None
    names = roster.names(arguments.roster) if arguments.roster else {}
    policies = late_policy.policies_of(course)
    times = hand_ins(arguments.folder, arguments.collected, policies, assignments.slugs(course))
    return report.run(arguments.folder, course, everyone, arguments.out, names, times)


def _course_and_slug(arguments: argparse.Namespace, graded: Sequence[Path]) -> tuple[Path, list[str], str | None]:
    """Return the course, its assignments, and the one that --assignment names (None without the option)."""
    course = course_config.course_of(arguments.root, graded)
    slugs = assignments.slugs(course)
    return course, slugs, assignments.match_slug(arguments.assignment, slugs)
