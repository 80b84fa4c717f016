"""Late policies from course.toml: when each assignment is due, what a day costs, and who has more time.

Only `policies` reads these keys. `tam570-grader points` turns them into rows of by_hand.csv, which all tables and pages
use. The comments of these rows name their source: if course.toml changes, these rows are replaced, others never.
"""

import math
from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from datetime import date, datetime, time, timedelta, tzinfo
from pathlib import Path

from tam570.values import Json
from tam570_grader.checks import assignments
from tam570_grader.course.course_toml import COPY, FILE, by_slug, is_number, must, no_other, toml
from tam570_grader.errors import UsageError, counted
from tam570_grader.results.collected import form, listed
from tam570_grader.results.manual_points import EVERYONE, EXTENSION, LATE, MOST, OFF, Entry, ManualAdjustments
from tam570_grader.results.store import Results

KEYS = ("due", "extension")  # keys of an assignment's table
RULES = ("off_a_day", "most_off", "grace")  # keys of [late], besides zone
NEEDED = ("student", "assignment", "file", "when", "late")  # columns of collected.csv
BY_COURSE, BY_TABLE = f"by {FILE}", "by collected.csv"
DAY = timedelta(days=1)
REMEDY = "collect again with --times, if the system has a table of them"


@dataclass(frozen=True)
class LatePolicy:
    """The late policy of an assignment."""

    due: datetime | None = None
    extension: Mapping[str, float] = field(default_factory=dict)  # days by student
    off: float = 0.0  # share of the score that a day costs
    most: float = 1.0  # largest share that late days cost
    grace: timedelta = timedelta()  # delay that does not count as late
    zone: tzinfo | None = None  # time zone of the course; None: this computer's


def policies_of(course: Path) -> dict[str, LatePolicy]:
    """Return the late policies of a course by slug; none if the course was not generated from a course.toml."""
    path = course / COPY
    return policies(path, toml(path), assignments.slugs(course)) if path.is_file() else {}


def policies(path: Path, table: Json, slugs: Sequence[str]) -> dict[str, LatePolicy]:
    """Return the late policies of these assignments; raise UsageError with the key of an invalid value."""
    from zoneinfo import ZoneInfo  # imported late: few commands need it

    rules = table.get("late", {})
    must(path, isinstance(rules, dict), "late must be a table: write [late] above its lines")
    no_other(path, "[late] ", rules, (*RULES, "zone"))
    for name, largest in zip(RULES, (1, 1, 24 * 60), strict=True):
        value = rules.get(name, 0)
        must(path, is_number(value, largest), f"[late] {name} is {value!r}; write a number from 0 to {largest}")
    off, most, grace = rules.get("off_a_day", 0.0), rules.get("most_off", 1.0), timedelta(minutes=rules.get("grace", 0))
    tables = by_slug(path, table, slugs)
    terms_of = {slug: _of_assignment(path, *tables[slug]) if slug in tables else (None, {}) for slug in slugs}
    try:
        zone = ZoneInfo(name) if (name := rules.get("zone")) is not None else None
    except (ValueError, TypeError, LookupError, OSError):
        raise UsageError(f"{path}: [late] zone is {name!r}; write a zone such as America/New_York") from None
    return {slug: LatePolicy(*policy, off, most, grace, zone) for slug, policy in terms_of.items()}


def _of_assignment(path: Path, key: str, table: Json) -> tuple[datetime | None, dict[str, float]]:
    """Return when an assignment is due (None: no date), and the extensions in days by student."""
    due, days = table.get("due"), table.get("extension", {})
    good = due is None or isinstance(due, date)
    must(path, good, f"[{key}] due is {due!r}; write a date and a time, 2026-09-14T23:59:00 say")
    must(path, isinstance(days, dict), f"[{key}] extension is a table of students: write [{key}.extension]")
    for who, number in days.items():
        must(path, is_number(number), f"[{key}.extension] {who} is {number!r}; write days, from 0 on")
    if due is not None and not isinstance(due, datetime):
        due = datetime.combine(due, time(23, 59, 59))
    return due, days


def apply_late_policy(
    adjustments: ManualAdjustments, policies: Mapping[str, LatePolicy], results: Results, collected: Path | None
) -> tuple[ManualAdjustments, list[str], list[str]]:
    """Return the adjustments with rows for the late policies, sentences on what an instructor must decide, and notes.

    results   : used to see whether a module or a notebook was graded, because that file's time counts
    collected : the table that `collect` wrote, with the times of the files
    """
    slugs = {slug for _, slug in results}
    table = list(_graded(listed(collected, NEEDED), results)) if collected else []
    days, open_ = _days(policies, adjustments, table, collected)
    open_ += _unknown_students(policies, results)
    untimed = sum(not (row["when"] or row["late"]) for row in table)
    warning = f"{counted(untimed, 'file')} in {collected} have no time: nobody is late by them; {REMEDY}"
    anew = {(BY_TABLE, row["assignment"]) for row in table}  # rows that the table replaces
    manual = {
        key: entry
        for key, entry in adjustments.entries.items()
        if _source(entry) != BY_COURSE and (_source(entry), entry.slug) not in anew
    }
    rows = [entry for entry in _rows(policies) if entry.slug in slugs]
    for entry in rows:
        other = manual.get(entry.key)
        if other and other.points != entry.points:
            raise UsageError(
                f"{entry.item} of {entry.student} in {entry.slug} is {entry.points:g} in {FILE}, {other.points:g} by "
                "hand: change one, or take the row back by one without points"
            )
    # rows written by hand have precedence over times
    late = [entry for entry in days if entry.slug in slugs and entry.key not in manual]
    return ManualAdjustments(manual.values()).with_([*rows, *late]), open_, [warning] if untimed else []


def _graded(table: Iterable[Mapping[str, str]], results: Results) -> Iterator[Mapping[str, str]]:
    """Yield the rows of the graded files: if a student handed in a module and a notebook, only the graded one's."""
    forms = defaultdict[tuple[str, str], dict[str, Mapping[str, str]]](dict)
    for row in table:
        if form(row["file"]):  # a module or notebook, not a drawing
            forms[row["student"], row["assignment"]][Path(row["file"]).suffix] = row
    for key, rows in forms.items():
        is_notebook = len(rows) > 1 and key in results and results[key].get("notebook")
        yield rows.get(".ipynb" if is_notebook else ".py") or next(iter(rows.values()))


def stale(folder: Path, adjustments: ManualAdjustments, course: Path, slugs: Collection[str]) -> str:
    """Return a sentence if the rows in by_hand.csv differ from the late policies in course.toml, else ""."""
    policies = {slug: policy for slug, policy in policies_of(course).items() if slug in slugs}
    applied = [entry for entry in adjustments.entries.values() if entry.slug in slugs]
    wanted = {entry.key: entry.points for entry in _rows(policies)}
    same = wanted.items() <= {entry.key: entry.points for entry in applied}.items()
    gone = {entry.key for entry in applied if entry.comment == BY_COURSE} - wanted.keys()
    moved = [
        entry
        for entry in applied
        if _source(entry) == BY_TABLE and entry.comment != _by(policies.get(entry.slug, LatePolicy()))
    ]
    if same and not gone and not moved:
        return ""
    times = " --collected collected.csv" if moved else ""
    return f"{FILE} has other terms for late work than {folder}: tam570-grader points {folder}{times}"


def _rows(policies: Mapping[str, LatePolicy]) -> Iterator[Entry]:
    """Yield the rows of by_hand.csv that express the late policies."""
    for slug, policy in policies.items():
        if policy.off:
            yield Entry(EVERYONE, slug, OFF, float(policy.off), None, BY_COURSE)
        if policy.off and policy.most < 1:
            yield Entry(EVERYONE, slug, MOST, float(policy.most), None, BY_COURSE)
        yield from (Entry(who, slug, EXTENSION, float(days), None, BY_COURSE) for who, days in policy.extension.items())


def _days(
    policies: Mapping[str, LatePolicy],
    adjustments: ManualAdjustments,
    table: Sequence[Mapping[str, str]],
    collected: Path | None,
) -> tuple[list[Entry], list[str]]:
    """Return the late days of each late file in `table`, and a sentence for each late file without a time."""
    late, open_ = dict[tuple[str, str], float](), []
    manual_rows = (entry for entry in adjustments.entries.values() if _source(entry) != BY_TABLE)
    answered = {(entry.student, entry.slug) for entry in manual_rows if entry.item == LATE}
    for cells in table:
        student, slug, when = cells["student"], cells["assignment"], cells["when"]
        due = policies.get(slug, LatePolicy()).due
        if when and due is not None:
            late[student, slug] = days_between(due, moment(when, collected), policies[slug])
        elif cells["late"] and due is not None and (student, slug) not in answered:
            open_.append(f"{student} is late in {slug}, and {collected} does not say when: add a row {LATE} by hand")
    rows = [(*key, LATE, math.ceil(100 * days) / 100, None, _by(policies[key[1]])) for key, days in late.items()]
    return [Entry(*row) for row in rows if row[3] > 0], open_


def days_between(due: datetime, when: datetime, policy: LatePolicy) -> float:
    """Return the days from `due` plus grace to `when` in the course's local time: a day of 25 hours counts as one."""
    return (on_the_wall(when, policy.zone) - on_the_wall(due, policy.zone) - policy.grace) / DAY


def on_the_wall(moment: datetime, zone: tzinfo | None) -> datetime:
    """Return a time as naive local time of the course; a time without a zone is local already."""
    return moment.astimezone(zone).replace(tzinfo=None) if moment.tzinfo else moment


def moment(text: str, collected: Path | None) -> datetime:
    """Return the time in a cell; without a zone, it is naive, local time. UsageError if the text is no time."""
    try:
        return datetime.fromisoformat(text.replace(" UTC", "Z").replace(" Z", "Z"))
    except ValueError:
        raise UsageError(f"{collected} has the time {text!r}; write it as 2026-09-14 23:59:00") from None


def _by(policy: LatePolicy) -> str:
    return f"{BY_TABLE}, due {policy.due:%Y-%m-%d %H:%M}" if policy.due else BY_TABLE


def _source(entry: Entry) -> str:
    return entry.comment.partition(",")[0]


def _unknown_students(policies: Mapping[str, LatePolicy], graded: Collection[tuple[str, str]]) -> list[str]:
    """Return a sentence for each student with an extension but without results: the name may be misspelt."""
    students, slugs = {student for student, _ in graded}, {slug for _, slug in graded}
    here = {slug: policy for slug, policy in policies.items() if slug in slugs}
    unknown = {(who, slug) for slug, policy in here.items() for who in policy.extension.keys() - students}
    return [f"{FILE} gives {who} more time in {slug}; no results are theirs" for who, slug in sorted(unknown)]
