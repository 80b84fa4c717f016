"""Late work by course.toml: when each assignment is due, what a day costs, and who has more time.

`policies` alone reads these keys. `tam570-grader points` makes rows of by_hand.csv of them, which all tables and pages
obey. The comments of such rows say where they come from: they are replaced when course.toml changes, others never.
"""

import math
from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from datetime import date, datetime, time, timedelta, tzinfo
from pathlib import Path
from typing import Any
from zoneinfo import ZoneInfo

from tam570_grader.course.course_toml import COPY, FILE, by_slug, must, no_other, toml
from tam570_grader.errors import UsageError, counted
from tam570_grader.results.collected import form
from tam570_grader.results.manual_points import EVERYONE, EXTENSION, LATE, MOST, OFF, Entry, ManualAdjustments
from tam570_grader.results.store import Results

__all__ = [
    "KEYS",
    "NEEDED",
    "LatePolicy",
    "apply_late_policy",
    "days_between",
    "moment",
    "on_the_wall",
    "policies",
    "policies_of",
    "stale",
]

KEYS = ("due", "extension")  # of an assignment's table
RULES = ("off_a_day", "most_off", "grace")  # of [late], beside its zone
NEEDED = ("student", "assignment", "file", "when", "late")  # columns of collected.csv
BY_COURSE, BY_TABLE = f"by {FILE}", "by collected.csv"
DAY = timedelta(days=1)
REMEDY = "collect again with --times, if the system has a table of them"


@dataclass(frozen=True)
class LatePolicy:
    """The terms of an assignment."""

    due: datetime | None = None
    extension: Mapping[str, float] = field(default_factory=dict)  # student: days
    off: float = 0.0  # the share of the score that a day costs
    most: float = 1.0  # the largest share that is taken off
    grace: timedelta = timedelta()  # how late is not late yet
    zone: tzinfo | None = None  # of the course; None: this computer's


def policies_of(course: Path) -> dict[str, LatePolicy]:
    """The terms of a course, by the names of its assignments; those that no course.toml made have none."""
    from tam570_grader.checks import assignments

    path = course / COPY
    return policies(path, toml(path), assignments.slugs(course)) if path.is_file() else {}


def policies(path: Path, given: Mapping[str, Any], slugs: Sequence[str]) -> dict[str, LatePolicy]:
    """The terms of these assignments; UsageError, with its key, for what does not fit."""
    rules = given.get("late", {})
    must(path, isinstance(rules, dict), "late must be a table: write [late] above its lines")
    no_other(path, "[late] ", rules, (*RULES, "zone"))
    for name, largest in zip(RULES, (1, 1, 24 * 60), strict=True):
        good = _is_number(rules.get(name, 0)) and 0 <= rules.get(name, 0) <= largest
        must(path, good, f"[late] {name} is {rules.get(name)!r}; write a number from 0 to {largest}")
    off, most, grace = rules.get("off_a_day", 0.0), rules.get("most_off", 1.0), timedelta(minutes=rules.get("grace", 0))
    tables = by_slug(path, given, slugs)
    own = {slug: _own(path, *tables[slug]) if slug in tables else (None, {}) for slug in slugs}
    zone = _zone(path, rules.get("zone"))
    return {slug: LatePolicy(*one, off, most, grace, zone) for slug, one in own.items()}


def _zone(path: Path, name: Any) -> tzinfo | None:
    """The zone of the course's clocks; None for this computer's."""
    try:
        return None if name is None else ZoneInfo(name)
    except (ValueError, TypeError, LookupError, OSError):
        must(path, False, f"[late] zone is {name!r}; write a zone such as America/New_York")
        raise


def _own(path: Path, key: str, given: Mapping[str, Any]) -> tuple[datetime | None, dict[str, float]]:
    """When an assignment is due, and the days that students have beyond."""
    due, days = given.get("due"), given.get("extension", {})
    good = due is None or isinstance(due, date)
    must(path, good, f"[{key}] due is {due!r}; write a date and a time, 2026-09-14T23:59:00 say")
    must(path, isinstance(days, dict), f"[{key}] extension is a table of students: write [{key}.extension]")
    for who, number in days.items():
        good = _is_number(number) and number >= 0
        must(path, good, f"[{key}.extension] {who} is {number!r}; write days, from 0 on")
    if due is not None and not isinstance(due, datetime):
        due = datetime.combine(due, time(23, 59, 59))
    return due, days


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)


def apply_late_policy(
    hand: ManualAdjustments, known: Mapping[str, LatePolicy], found: Results, collected: Path | None
) -> tuple[ManualAdjustments, list[str], list[str]]:
    """What was added by hand with the rows that the terms make, sentences on what they leave open, and notes.

    found     : the results, which tell what was graded: of a module and a notebook the time of one counts
    collected : the table that `collect` wrote, whose times tell who is late
    """
    from tam570_grader.results.collected import listed

    slugs = {slug for _, slug in found}
    table = list(_graded(listed(collected, NEEDED), found)) if collected else []
    days, open_ = _days(known, hand, table, collected)
    open_ += _strangers(known, found)
    untimed = sum(not (row["when"] or row["late"]) for row in table)
    notes = [f"{counted(untimed, 'file')} in {collected} have no time: nobody is late by them; {REMEDY}"] * bool(
        untimed
    )
    anew = {row["assignment"] for row in table}  # the times of the others stand in no table now
    own = {key: one for key, one in hand.entries.items() if not _is_made_anew(one, anew)}
    rows = [one for one in _rows(known) if one.slug in slugs]
    for one in rows:
        other = own.get(one.key)
        if other and other.points != one.points:
            raise UsageError(
                f"{one.item} of {one.student} in {one.slug} is {one.points:g} in {FILE}, {other.points:g} by hand: "
                "change one, or take the row back by one without points"
            )
    late = [one for one in days if one.slug in slugs and one.key not in own]  # a row by hand knows better than a clock
    return ManualAdjustments(own.values()).with_([*rows, *late]), open_, notes


def _graded(table: Iterable[Mapping[str, str]], found: Results) -> Iterator[Mapping[str, str]]:
    """The rows of the files that count: of a module and a notebook side by side the one that was graded."""
    forms = defaultdict[tuple[str, str], dict[str, Mapping[str, str]]](dict)
    for row in table:
        if form(row["file"]):  # not a drawing beside it
            forms[row["student"], row["assignment"]][Path(row["file"]).suffix] = row
    for key, rows in forms.items():
        is_notebook = len(rows) > 1 and key in found and found[key].get("notebook")
        yield rows.get(".ipynb" if is_notebook else ".py") or next(iter(rows.values()))


def stale(folder: Path, hand: ManualAdjustments, course: Path, slugs: Collection[str]) -> str:
    """A sentence if the results do not have what course.toml says of late work; else empty."""
    known = {slug: one for slug, one in policies_of(course).items() if slug in slugs}
    made = [one for one in hand.entries.values() if one.slug in slugs]
    same = {one.key: one.points for one in _rows(known)}.items() <= {one.key: one.points for one in made}.items()
    gone = {one.key for one in made if one.comment == BY_COURSE} - {one.key for one in _rows(known)}
    moved = [one for one in made if _source(one) == BY_TABLE and one.comment != _by(known.get(one.slug, LatePolicy()))]
    if same and not gone and not moved:
        return ""
    times = " --collected collected.csv" if moved else ""
    return f"{FILE} has other terms for late work than {folder}: tam570-grader points {folder}{times}"


def _rows(known: Mapping[str, LatePolicy]) -> Iterator[Entry]:
    """The rows of by_hand.csv that say the terms."""
    for slug, one in known.items():
        if one.off:
            yield Entry(EVERYONE, slug, OFF, float(one.off), None, BY_COURSE)
        if one.off and one.most < 1:
            yield Entry(EVERYONE, slug, MOST, float(one.most), None, BY_COURSE)
        yield from (Entry(who, slug, EXTENSION, float(days), None, BY_COURSE) for who, days in one.extension.items())


def _days(
    known: Mapping[str, LatePolicy], hand: ManualAdjustments, table: Sequence[Mapping[str, str]], collected: Path | None
) -> tuple[list[Entry], list[str]]:
    """Rows with the days of whom collected.csv shows late, and a sentence for each whose time it does not tell.

    Who is not marked late, and has no time, is not late.
    """
    late, open_, answered = dict[tuple[str, str], float](), [], _by_hand(hand)
    for cells in table:
        student, slug, when = cells["student"], cells["assignment"], cells["when"]
        due = known.get(slug, LatePolicy()).due
        if when and due is not None:
            late[student, slug] = days_between(due, moment(when, collected), known[slug])
        elif cells["late"] and due is not None and (student, slug) not in answered:
            open_.append(f"{student} is late in {slug}, and {collected} does not say when: add a row {LATE} by hand")
    found = [(*key, LATE, math.ceil(100 * days) / 100, None, _by(known[key[1]])) for key, days in late.items()]
    return [Entry(*one) for one in found if one[3] > 0], open_


def _by_hand(hand: ManualAdjustments) -> set[tuple[str, str]]:
    """Whose late days somebody wrote down."""
    return {(one.student, one.slug) for one in hand.entries.values() if one.item == LATE and _source(one) != BY_TABLE}


def days_between(due: datetime, when: datetime, one: LatePolicy) -> float:
    """Days by the calendar and the clock on the wall, so that a day with 25 hours is one."""
    return (on_the_wall(when, one.zone) - on_the_wall(due, one.zone) - one.grace) / DAY


def on_the_wall(moment: datetime, zone: tzinfo | None) -> datetime:
    """A time as the clocks of the course show it; one without a zone is of them."""
    return moment.astimezone(zone).replace(tzinfo=None) if moment.tzinfo else moment


def moment(text: str, collected: Path | None) -> datetime:
    """The time in a cell; one without a zone is of this computer's."""
    try:
        return datetime.fromisoformat(text.replace(" UTC", "Z").replace(" Z", "Z"))
    except ValueError:
        raise UsageError(f"{collected} has the time {text!r}; write it as 2026-09-14 23:59:00") from None


def _by(one: LatePolicy) -> str:
    return f"{BY_TABLE}, due {one.due:%Y-%m-%d %H:%M}" if one.due else BY_TABLE


def _is_made_anew(one: Entry, anew: Collection[str]) -> bool:
    """Whether a row comes from course.toml, or from the times of one of these assignments."""
    return _source(one) == BY_COURSE or _source(one) == BY_TABLE and one.slug in anew


def _source(one: Entry) -> str:
    return one.comment.partition(",")[0]


def _strangers(known: Mapping[str, LatePolicy], found: Collection[tuple[str, str]]) -> list[str]:
    """Students with more time who have no results, a slip in a name perhaps."""
    students, slugs = {student for student, _ in found}, {slug for _, slug in found}
    named = {(who, slug) for slug, one in known.items() if slug in slugs for who in one.extension}
    return [
        f"{FILE} gives {who} more time in {slug}; no results are theirs"
        for who, slug in sorted(named)
        if who not in students
    ]
