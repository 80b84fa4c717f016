"""Adjustments that an instructor makes by hand: points for written answers, corrections, late days, extensions.

`by_hand.csv` beside `results.jsonl` has a row for each student, assignment and item. An item is the letter of a part
that is graded by hand, the name of a check whose points the row replaces, or a word: `adjust` adds points, `total` sets
the score, `late` is the number of days late, `extension` the number allowed, `off a day` the share of the score that a
day costs, `most off` the largest share lost, `excused` removes a result from the grade. The student `*` means everyone;
the assignment `*` means all: `slip days` then pay for late days in the assignments' order, `drop lowest` drops results.
"""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import astuple, dataclass, replace
from pathlib import Path
from typing import NamedTuple

from tam570_grader.errors import UsageError
from tam570_grader.results.records import Result
from tam570_grader.results.tables import by_column, name_in, write_table

Key = tuple[str, str]  # student, assignment
Score = float | str | None  # EX if the student is excused
Earned = Callable[[], Mapping[str, float | None]]  # points by check; called only if a row names a check

FILE = "by_hand.csv"
COLUMNS = ("student", "assignment", "item", "points", "of", "comment")
EVERYONE = "*"
ADJUST, TOTAL, LATE, EXTENSION, OFF, MOST = "adjust", "total", "late", "extension", "off a day", "most off"
EXCUSED, SLIP, DROP = "excused", "slip days", "drop lowest"
WORDS = (ADJUST, TOTAL, LATE, EXTENSION, OFF, MOST, EXCUSED, SLIP, DROP)
OF_THE_TERM = (EXTENSION, OFF, MOST, SLIP, DROP)  # items allowed for the assignment *
EX = "EX"  # score of an excused student, as in Canvas


class GradeRow(NamedTuple):
    """A row of the table of grades."""

    student: str
    assignment: str
    status: str
    score: Score
    max_score: float

    @property
    def key(self) -> Key:
        return self.student, self.assignment


@dataclass(frozen=True)
class Entry:
    """One row of `by_hand.csv`: points, days or a share, with a comment."""

    student: str
    slug: str
    item: str
    points: float | None  # None: not graded yet
    of: float | None = None  # maximum of a part that is graded by hand
    comment: str = ""

    @property
    def key(self) -> tuple[str, str, str]:
        return self.student, self.slug, self.item


@dataclass(frozen=True)
class AdjustedScore:
    """A score with all adjustments, and the sentences that describe them."""

    score: float | None
    most: float
    message: tuple[str, ...] = ()
    parts: tuple[str, ...] = ()  # letters of the hand-graded parts included in `most`
    excused: bool = False


class ManualAdjustments:
    """All rows of `by_hand.csv`, and what they change in results."""

    def __init__(self, entries: Iterable[Entry] = ()) -> None:
        self.entries = {entry.key: entry for entry in entries}
        self._of: dict[Key, dict[str, Entry]] = {}
        for entry in self.entries.values():
            self._of.setdefault((entry.student, entry.slug), {})[entry.item] = entry

    def with_(self, entries: Iterable[Entry]) -> "ManualAdjustments":
        """Return the adjustments with newer entries; an entry with neither `points` nor `of` deletes its row."""
        newest = {**self.entries, **{entry.key: entry for entry in entries}}
        return ManualAdjustments(entry for entry in newest.values() if entry.points is not None or entry.of is not None)

    def _rows(self, key: Key) -> dict[str, Entry]:
        """Return the rows of a result by item: a student's before everyone's, an assignment's before the term's."""
        return {item: entry for layer in _layers(key) for item, entry in self._of.get(layer, {}).items()}

    def is_missing(self, key: Key, part: str) -> bool:
        """Return whether a part still must be graded by hand: it has no points, and no `total` or `excused` row."""
        points = {item: row.points for item, row in self._rows(key).items()}
        return points.get(part) is None and TOTAL not in points and not points.get(EXCUSED)

    def is_late_free(self, late: Entry) -> bool:
        """Return whether no row says what the days of this `late` row cost."""
        return bool(late.points) and OFF not in self._rows((late.student, late.slug))

    def counts_parts(self, slug: str) -> bool:
        """Return whether everyone's maximum score includes the parts graded by hand."""
        return any(entry.of is not None for entry in self._of.get((EVERYONE, slug), {}).values())

    def adjust(self, graded: GradeRow, earned_of: Earned) -> AdjustedScore | None:
        """Return a result's score with all adjustments; None if no row applies to it, or if it is excused already."""
        key, score, most = graded.key, graded.score, graded.max_score
        if isinstance(score, str) or not (mine := self._rows(key)):
            return None
        parts = [row for row in mine.values() if row.of is not None]
        added = [row.points for row in parts if row.points is not None]
        most += sum(row.of or 0.0 for row in parts)
        message = [_part(row) for row in sorted(parts, key=lambda row: row.item)]
        if checks := {item: row for item, row in mine.items() if row.of is None and item not in WORDS}:
            score, replaced = _checks(score, checks, earned_of())
            message += replaced
        if adjusted := mine.get(ADJUST):
            added.append(adjusted.points or 0.0)
            message.append(f"{adjusted.points:+g} points by hand: {adjusted.comment}")
        earned = None if score is None else max(0.0, score + sum(added))
        earned, late = _late(earned, {item: row.points or 0.0 for item, row in mine.items()}, self._slip(key))
        if total := mine.get(TOTAL):
            earned = total.points
            late.append(f"{earned:g} points in all, by hand: {total.comment}")
        letters = tuple(row.item for row in parts)
        if (excused := mine.get(EXCUSED)) and excused.points:
            reason = f"You are excused from this assignment. {excused.comment}".strip()
            return AdjustedScore(None, most, (*message, reason), letters, excused=True)
        return AdjustedScore(None if earned is None else round(earned, 6), most, (*message, *late), letters)

    def _slip(self, key: Key) -> float:
        """Return the slip days that a result uses; assignments use up the term's slip days in order of their slugs."""
        rest = next((row.points or 0.0 for item, row in self._rows(key).items() if item == SLIP), 0.0)
        if not rest:
            return 0.0
        for slug in sorted({slug for _, slug in self._of if slug != EVERYONE}):
            rows = self._rows((key[0], slug))
            days = _days({item: row.points or 0.0 for item, row in rows.items()})
            days_taken = min(rest, days if LATE in rows else 0)
            if slug == key[1]:
                return days_taken
            rest -= days_taken
        return 0.0

    def table(self, rows: Iterable[GradeRow]) -> list[GradeRow]:
        """Return the table of grades, with EX as the score of results that the course drops."""
        rows = list(rows)
        dropped = self.dropped(rows)
        return [row._replace(score=EX) if row.key in dropped else row for row in rows]

    def dropped(self, rows: Iterable[GradeRow]) -> set[Key]:
        """Return the keys of each student's lowest results, as many as the course drops."""
        counting: dict[str, list[tuple[float, Key]]] = {}  # by student: share of the maximum score, key
        for row in rows:
            if isinstance(row.score, int | float) and row.max_score:
                counting.setdefault(row.student, []).append((row.score / row.max_score, row.key))
        dropped = set[Key]()
        for student, results in counting.items():
            drop = self._rows((student, EVERYONE)).get(DROP)
            count = min(int(drop.points or 0), len(results) - 1) if drop else 0
            dropped |= {key for _, key in sorted(results, key=lambda result: result[0])[:count]}
        return dropped

    def applied(self, result: Result) -> Result:
        """Return a result with its adjusted score."""
        graded = GradeRow(result.student, result.assignment, result.status, result.score, result.max_score)
        adjusted = self.adjust(graded, lambda: {check.name: check.points for check in result.checks})
        if adjusted is None:
            return result
        status = EXCUSED if adjusted.excused else result.status
        return replace(result, status=status, score=adjusted.score, max_score=adjusted.most)

    def row(self, graded: GradeRow, earned_of: Earned) -> GradeRow:
        """Return a row of the table of grades with its adjusted score."""
        adjusted = self.adjust(graded, earned_of)
        if adjusted is None:
            return graded
        return graded._replace(score=EX if adjusted.excused else adjusted.score, max_score=adjusted.most)


def _layers(key: Key) -> tuple[Key, Key, Key, Key]:
    """Return the keys whose rows apply to a result, in increasing order of precedence."""
    student, slug = key
    return (EVERYONE, EVERYONE), (EVERYONE, slug), (student, EVERYONE), (student, slug)


def _part(entry: Entry) -> str:
    if entry.points is None:
        return f"Part ({entry.item}): up to {entry.of:g} points are given by hand, not yet."
    return f"Part ({entry.item}): {entry.points:g} of {entry.of:g} points, by hand. {entry.comment}".strip()


def _checks(
    score: float | None, rows: Mapping[str, Entry], earned: Mapping[str, float | None]
) -> tuple[float | None, list[str]]:
    """Return the score with the points of these checks replaced, and sentences; ignore checks that no longer exist."""
    here = {item: entry for item, entry in rows.items() if item in earned}
    if not here:
        return score, []
    points = [*{**earned, **{item: entry.points for item, entry in here.items()}}.values()]
    message = [
        f"{item.replace('_', ' ')}: {entry.points:g} points, by hand: {entry.comment}" for item, entry in here.items()
    ]
    return None if None in points else sum(filter(None, points)), message


def _days(items: Mapping[str, float]) -> int:
    """Return the days late beyond the extension, rounded up."""
    return math.ceil(max(0.0, items.get(LATE, 0.0) - items.get(EXTENSION, 0.0)))


def _late(earned: float | None, items: Mapping[str, float], slip_days: float) -> tuple[float | None, list[str]]:
    """Return a score less the penalty for days beyond extension and slip days, and the sentence that explains it."""
    off = min(items.get(MOST, 1.0), (_days(items) - slip_days) * items.get(OFF, 0.0))
    if not items.get(LATE):
        return earned, []
    allowed = f", {items[EXTENSION]:g} of them allowed" if items.get(EXTENSION) else ""
    allowed += f", {slip_days:g} of them slip days" if slip_days else ""
    word = "day" if items[LATE] == 1 else "days"
    message = f"{items[LATE]:g} {word} late{allowed}: {100 * off:g} % of the points are taken off."
    return None if earned is None else earned * (1 - off), [message]


def read(folder: Path) -> ManualAdjustments:
    """Read the adjustments beside the results in a folder, or beside a `results.jsonl`; none if there is no table."""
    path = (folder.parent if folder.is_file() else folder) / FILE
    return ManualAdjustments().with_(entry for _, entry in rows_of(path)) if path.exists() else ManualAdjustments()


def rows_of(path: Path) -> Iterator[tuple[int, Entry]]:
    """Yield line number and entry of each row of a table with the columns `COLUMNS`, in any order."""
    rows = by_column(path, ("student", "assignment", "item", "points"), f"; its heading is: {','.join(COLUMNS)}")
    for line, row in rows:
        cells = {name: text.strip() for name, text in row.items()}
        where = f"{path}, line {line}"
        points, of = (_number(cells.get(name, ""), f"{where}: {name}") for name in ("points", "of"))
        student, item, comment = name_in(cells["student"]), cells["item"], name_in(cells.get("comment", ""))
        yield line, Entry(student, cells["assignment"], item, points, None if item in WORDS else of, comment)


def _number(text: str, where: str) -> float | None:
    try:
        number = float(text.replace(",", ".")) if text else None  # 1,5 of spreadsheets in other languages
    except ValueError:
        number = math.nan
    if number is not None and not math.isfinite(number):
        raise UsageError(f"{where} is {text!r}, not a number; write 1.5, say, or leave it empty")
    return number


def join(folder: Path, others: Iterable[Path]) -> None:
    """Add the adjustments in other folders to those in this folder, which have precedence."""
    theirs = [entry for other in others for entry in read(other).entries.values()]
    if theirs:
        write(folder, ManualAdjustments(theirs).with_(read(folder).entries.values()))


def write(folder: Path, adjustments: ManualAdjustments) -> None:
    """Replace the table in a folder atomically."""
    rows = [
        ["" if value is None else value for value in astuple(entry)]
        for entry in sorted(adjustments.entries.values(), key=lambda entry: entry.key)
    ]
    write_table(folder / FILE, [COLUMNS, *rows])
