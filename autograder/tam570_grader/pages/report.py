"""The instructor's page on a class: one file made from the results, that sorts and filters by itself."""

import base64
import hashlib
import statistics
from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from tam570_grader.delivery.roster import students
from tam570_grader.errors import UsageError, writing
from tam570_grader.pages.feedback import Sheet, sheet, template
from tam570_grader.results.journal import Record, read, written

__all__ = ["report", "results", "run"]

SLOWEST = 20  # submissions that are listed
BINS = 10  # of a distribution of scores
OUTCOMES = ("passed", "failed", "not_run", "grader_error")
SCRIPT = Path(__file__).parent / "templates" / "report.js"


@dataclass(frozen=True)
class Tally:
    """How one check went in the class."""

    slug: str
    part: str
    line: str
    points: str
    counts: Mapping[str, int]  # by outcome

    @property
    def share(self) -> float:
        """Of those who handed in, in percent."""
        return round(100 * self.counts["passed"] / max(sum(self.counts.values()), 1), 1)


def run(folder: Path, course: Path, roster: Path | None, out: Path | None) -> int:
    """Write the report on the results in the folder; the exit code."""
    records = results(folder)
    place = out or folder / "report.html"
    names = students(roster, {record["student"] for record in records}) if roster else ()
    text = report(records, {slug: sheet(course, slug) for slug in _slugs(records)}, names)
    with writing(place):
        written(place, text)
    print(place)
    return 0


def results(folder: Path) -> list[Record]:
    """The newest result of every student and assignment; a last line that is being written is left out."""
    if not (folder / "results.jsonl").is_file():
        raise UsageError(f"there are no results in {folder}; make them with: tam570-grader grade ... --out {folder}")
    records = read(folder)
    if not records:
        raise UsageError(f"{folder / 'results.jsonl'} is empty; nothing has been graded yet")
    return sorted(records, key=lambda record: (record["student"], record["assignment"]))


def report(records: Sequence[Record], sheets: Mapping[str, Sheet], roster: Iterable[str] = ()) -> str:
    """The page, one HTML file that needs nothing else but, for its links, the feedback beside it."""
    script = SCRIPT.read_text(encoding="utf-8")
    students = sorted({record["student"] for record in records} | set(roster))
    text: str = template("report.html").render(
        slugs=_slugs(records),
        sheets=sheets,
        students=len(students),
        handed_in=sum(_here(record) for record in records),
        seeds=sorted({record["seed"] for record in records}),
        isolation=sorted({record["isolation"] for record in records}),
        assignments=[_assignment(slug, records, sheets[slug]) for slug in _slugs(records)],
        scores=_scores(records, students),
        tallies=_tallies(records, sheets),
        suspects=_suspects(records),
        slowest=sorted(records, key=_seconds, reverse=True)[:SLOWEST],
        faults=[(r, mark) for r in records for mark in r["checks"] if mark["outcome"] == "grader_error"],
        absent=_absent(records, students),
        script=script,
        script_hash=base64.b64encode(hashlib.sha256(script.encode()).digest()).decode(),
    )
    return text


def _slugs(records: Iterable[Record]) -> list[str]:
    return sorted({record["assignment"] for record in records})


def _here(record: Record) -> bool:
    return bool(record["status"] != "missing")


def _seconds(record: Record) -> float:
    return float(record["seconds"])


def _assignment(slug: str, records: Sequence[Record], sheet: Sheet) -> dict[str, Any]:
    """An assignment at a glance: the middle, the spread, how many have all."""
    mine = [record for record in records if record["assignment"] == slug and _here(record)]
    scores = [record["score"] for record in mine if record["score"] is not None]
    most = mine[0]["max_score"] if mine else 0
    bins = [0] * BINS
    for score in scores:
        bins[min(int(BINS * score / most), BINS - 1)] += 1
    return {
        "slug": slug,
        "title": sheet.title,
        "count": len(mine),
        "mean": round(statistics.fmean(scores), 2) if scores else None,
        "median": statistics.median(scores) if scores else None,
        "full": sum(score == most for score in scores),
        "most": most,
        "bins": bins,
        "highest": max(bins) or 1,
    }


def _scores(records: Sequence[Record], students: Sequence[str]) -> list[dict[str, Any]]:
    """A row for each student: a cell for each assignment, and the sum."""
    known = {(record["student"], record["assignment"]): record for record in records}
    rows = []
    for student in students:
        cells = [known.get((student, slug)) for slug in _slugs(records)]
        total = sum(cell["score"] or 0 for cell in cells if cell)
        rows.append({"student": student, "cells": cells, "total": round(total, 6)})
    return rows


def _tallies(records: Iterable[Record], sheets: Mapping[str, Sheet]) -> list[Tally]:
    """Of every check, in the order of the assignments, how many passed it, of those who handed in."""
    counts: dict[tuple[str, str], dict[str, int]] = defaultdict(lambda: dict.fromkeys(OUTCOMES, 0))
    marks = {}
    for record in filter(_here, records):
        for mark in record["checks"]:
            key = record["assignment"], mark["name"]
            counts[key][mark["outcome"]] += 1
            marks[key] = mark
    return [
        Tally(slug, mark["part"], sheets[slug].lines.get(name, name), f"{mark['max_points']:g}", counts[slug, name])
        for (slug, name), mark in sorted(marks.items(), key=lambda item: item[0][0])
    ]


def _suspects(records: Iterable[Record]) -> list[dict[str, Any]]:
    """The known mistakes, those of most students first."""
    who: dict[tuple[str, str], set[str]] = defaultdict(set)
    for record in records:
        for mark in record["checks"]:
            if mark["suspect"]:
                who[record["assignment"], mark["suspect"]].add(record["student"])
    found = [{"slug": slug, "says": says, "who": sorted(names)} for (slug, says), names in who.items()]
    return sorted(found, key=lambda it: (-len(it["who"]), it["slug"]))


def _absent(records: Sequence[Record], students: Sequence[str]) -> list[dict[str, Any]]:
    """For each assignment, who has handed in nothing."""
    here = {(record["student"], record["assignment"]) for record in records if _here(record)}
    return [
        {"slug": slug, "who": [student for student in students if (student, slug) not in here]}
        for slug in _slugs(records)
    ]
