"""Feedback pages for students, and the table of a class for the terminal; neither reveals hidden inputs."""

import functools
import importlib.util
import json
import os
import zlib
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING
from unicodedata import combining, east_asian_width

from tam570.values import Json
from tam570_grader.checks import assignments
from tam570_grader.checks.rubric import ManualPart
from tam570_grader.errors import UsageError, progress, warn
from tam570_grader.reports.sentences import capitalized, describe_failure, known_mistake, points, sentence, typeset
from tam570_grader.results import manual_points
from tam570_grader.results.manual_points import EX, AdjustedScore, ManualAdjustments
from tam570_grader.results.records import CheckResult, Result, read
from tam570_grader.results.store import Key, Record, Results
from tam570_grader.results.tables import write_in, written

if TYPE_CHECKING:
    from jinja2 import Template

TEMPLATES = Path(__file__).parent / "templates"
SIGNS = {"passed": "+", "failed": "-", "not_run": "o", "grader_error": "!"}
HEADINGS: tuple[str, ...] = ("student", "assignment", "score", "status", "time", "what to look at first")
NOTES = {
    "missing": "Nothing was found.",
    "unreadable": "Your file could not be read.",
    "timeout": "Your file took too long.",
    "crashed": "Your file ended the process.",
}
STOPPED = ("unreadable", "timeout", "crashed")  # statuses that the visible tests would have revealed


@dataclass(frozen=True)
class AssignmentInfo:
    """Facts about an assignment that are the same on every student's page."""

    title: str
    lines: Mapping[str, str]  # by check: what it tests
    functions: Mapping[str, str]  # by check: its function, for which there are hints
    manual: Mapping[str, ManualPart]  # by letter: the parts that are graded by hand


def load_assignment_info(course: Path, slug: str) -> AssignmentInfo:
    """Return the facts about an assignment; only its slug if it is no longer in the course."""
    if slug not in assignments.slugs(course):
        return AssignmentInfo(slug, {}, {}, {})
    assignment = assignments.assignment(course, slug)
    lines = {check.name: check.title for check in assignment.checks}
    functions = {check.name: check.function for check in assignment.checks}
    return AssignmentInfo(assignments.title(course, slug), lines, functions, assignment.rubric)


def page(result: Result, info: AssignmentInfo, adjusted: AdjustedScore | None = None) -> str:
    """Return a student's feedback on one assignment as a self-contained HTML file.

    adjusted : the score with adjustments by hand
    """
    from tam570_grader.reports.pictures import among  # imported late: only pages need it

    adjusted = adjusted or AdjustedScore(result.score, result.max_score)
    parts = [_part(letter, result, info) for letter in sorted({check.part for check in result.checks})]
    checks = [check for part in parts for check in part["marks"]]
    wrong = [check for check in checks if check["stuck"]]
    wrong.sort(key=lambda check: (not check["suspect"], check["outcome"] != "failed"))
    return template("feedback.html").render(
        slug=result.assignment,
        student=result.student,
        title=info.title,
        score=points(adjusted.score, adjusted.most),
        max_score=points(adjusted.most),
        remark=overall(result.status, result.message),
        stopped=result.status in STOPPED,
        parts=parts,
        manual=[
            (letter, points(part.points), part.asks)
            for letter, part in info.manual.items()
            if letter not in adjusted.parts
        ],
        adjustments=adjusted.message,
        first=next(iter(wrong), None),
        among=among(result.assignment, result.speed) if result.speed else None,
    )


def overall(status: str, message: str) -> str:
    """Return the remark on a submission as a whole; "" if there is none."""
    return sentence(capitalized(message)) or NOTES.get(status, "")


def must_write_pages() -> None:
    """Raise UsageError if Jinja2 is not installed: called before grading, as pages need it only at the end."""
    if importlib.util.find_spec("jinja2") is None:
        raise UsageError("the pages of feedback and the report need Jinja2: pip install 'tam570[grader]'")


@functools.cache
def template(name: str) -> "Template":
    """Return the template of a page; it escapes all inserted text."""
    import jinja2

    loader = jinja2.FileSystemLoader(TEMPLATES)
    pages = jinja2.Environment(
        loader=loader, autoescape=True, undefined=jinja2.StrictUndefined, trim_blocks=True, lstrip_blocks=True
    )
    pages.filters |= {"typeset": typeset, "points": points}
    return pages.get_template(name)


def _part(letter: str, result: Result, info: AssignmentInfo) -> Json:
    checks = [check for check in result.checks if check.part == letter]
    each = [check.points for check in checks]
    earned = None if None in each else sum(filter(None, each))
    most = sum(check.max_points for check in checks)
    return {
        "letter": letter,
        "points": points(earned, most),
        "max_points": points(most),
        "share": round(100 * (earned or 0) / most, 1) if most else 0,
        "marks": [shown(check, info, result.message) for check in checks],
    }


def shown(check: CheckResult, info: AssignmentInfo, overall_message: str) -> Json:
    """Return what a page shows of a check, without a message that all share and `error`, which is the instructor's."""
    from tam570_grader.reports.pictures import pictures, sketch

    failure, is_stuck = check.failure, check.outcome == "failed" or bool(check.unwritten)
    function = (failure and failure.function) or check.unwritten or info.functions.get(check.name)
    message = "" if check.message == overall_message else check.message
    return {
        "name": check.name,
        "outcome": check.outcome,
        "line": info.lines.get(check.name, check.name),
        "stuck": is_stuck,
        "points": points(check.points, check.max_points),
        "max_points": points(check.max_points),
        "message": describe_failure(failure) if failure else message,
        "suspect": check.suspect and known_mistake(check.suspect),
        "sketch": sketch(failure.sketch) if failure and failure.sketch else None,
        "pictures": pictures(failure.curve if failure else None),
        "hint": function if is_stuck else None,
    }


def write_pages(folder: Path, results: Results, course: Path) -> list[Key]:
    """Write the page of each student and assignment, `<student>/<assignment>.html`, unless it is up to date.

    Return the keys of pages that could not be made; a page that says so replaces them.

    A file beside the folder (which is for students) records a digest of the data from which each page was made.
    """
    engine = assignments.engine_digest() + b"".join(path.read_bytes() for path in sorted(TEMPLATES.iterdir()))
    info_digests = {  # of all that `load_assignment_info` would read, to avoid loading it
        slug: zlib.crc32(assignments.title(course, slug).encode() + assignments.checks_digest(course, slug) + engine)
        for slug in {slug for _, slug in results.lines}
    }
    adjustments = manual_points.read(folder.parent)
    adjusted = _adjusted(adjustments, results)
    digests = {key: f"{line.line_digest} {info_digests[key[1]]}" for key, line in results.lines.items()}
    for key, score in adjusted.items():
        digests[key] += f" {zlib.crc32(repr(score).encode())}"
    notes = folder.with_name(f".{folder.name}-made.json")
    try:
        old = dict(json.loads(notes.read_text(encoding="utf-8")))
    except (OSError, ValueError, TypeError):
        old = {}
    stale = [key for key in results if old.get("/".join(key)) != digests[key] or not os.path.exists(_path(folder, key))]
    if stale:
        notes.unlink(missing_ok=True)  # wrong as soon as the first page is written, if this run is killed
    infos = {slug: load_assignment_info(course, slug) for slug in {slug for _, slug in stale}}
    failed = []
    for key in progress(stale, len(stale), "page"):
        try:
            text = page(read(results[key]), infos[key[1]], adjusted.get(key))
        except Exception as error:  # the other students still get their pages
            warn(f"the page of {key[0]} {key[1]} could not be made: {error!r}")
            text = template("no_page.html").render(slug=key[1], student=key[0])
            failed.append(key)
        write_page(folder, key, text)
    if stale:
        written(notes, json.dumps({"/".join(key): digest for key, digest in digests.items() if key not in failed}))
    return failed


def write_page(folder: Path, key: Key, text: str) -> None:
    """Write a page unless it is unchanged; replace links on its path instead of following them."""
    path = Path(_path(folder, key))
    for target in (folder, path.parent):
        if target.is_symlink():
            target.unlink()
        target.mkdir(parents=True, exist_ok=True)
    if path.is_symlink() or not path.exists() or path.read_text(encoding="utf-8") != text:
        write_in(path.parent, path.name, text)


def _adjusted(adjustments: ManualAdjustments, results: Results) -> dict[Key, AdjustedScore]:
    """Return the adjusted scores of the results that have adjustments by hand."""
    scores = {key: adjustments.adjust(line.graded, results.earned(key)) for key, line in results.lines.items()}
    return {key: score for key, score in scores.items() if score}


def _path(folder: Path, key: Key) -> str:
    return f"{folder}/{key[0]}/{key[1]}.html"


def table(rows: Sequence[tuple[str, ...]]) -> str:
    """Return the table of the class as text: a line for each submission, with its most important remark."""
    rows = [HEADINGS, *rows]
    ends = [max(_width(row[column]) for row in rows) for column in range(5)]
    padded = [[text + " " * (end - _width(text)) for text, end in zip(row, ends, strict=False)] for row in rows]
    return "\n".join("  ".join([*cells, row[5]]).rstrip() for cells, row in zip(padded, rows, strict=True))


def _width(text: str) -> int:
    """Return the columns that a text takes on a terminal: two for a Chinese character, none for a combining accent."""
    return sum(0 if combining(letter) else 1 + (east_asian_width(letter) in "WF") for letter in text)


def with_hand(
    rows: Iterable[tuple[str, ...]], results: Results, adjustments: ManualAdjustments
) -> list[tuple[str, ...]]:
    """Return the rows of the table with scores adjusted by hand."""
    scores = {
        key: f"{EX:>5} / {points(it.most)}" if it.excused else _score(it.score, it.most)
        for key, it in _adjusted(adjustments, results).items()
    }
    return [(*row[:2], scores.get((row[0], row[1]), row[2]), *row[3:]) for row in rows]


def _score(score: float | None, most: float) -> str:
    return f"{points(score, most):>5} / {points(most)}"


def row(record: Record) -> tuple[str, ...]:
    """Return a result's row of the table."""
    score = _score(record["score"], record["max_score"])
    seconds = f"{record['seconds']:.2f} s"
    return record["student"], record["assignment"], score, record["status"], seconds, _remark(record)


def _remark(record: Record) -> str:
    """Return the most important remark: a known mistake, else the message, the first failure or a missing function."""
    checks = [check for check in record["checks"] if check["outcome"] not in ("passed", "not_run")]
    suspected = next((check["suspect"] for check in checks if check["suspect"]), None)
    if suspected:
        return f"numbers match: {sentence(suspected)}"
    unwritten = [check["message"] for check in record["checks"] if check.get("unwritten")]
    first = [f"{check['name']}: {check['message']}" for check in checks]
    text = " ".join((record.get("message") or next(iter([*first, *unwritten]), "")).split())
    return text if len(text) <= 90 else text[:89] + "…"
