"""When and how often students handed in: rows of the report, from collected.csv and the journal of `watch`."""

import json
import statistics
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from datetime import datetime
from pathlib import Path

from tam570.values import Json
from tam570_grader.course.late_policy import NEEDED, LatePolicy, days_between, moment, on_the_wall
from tam570_grader.grading.watch import JOURNAL
from tam570_grader.results.collected import OLDER, form, listed

DAYS = 8  # bins, of one day each, before the due date; the first includes all earlier days
HandIn = tuple[str, str, datetime | None]  # student, assignment, time


def hand_ins(
    folder: Path, collected: Path | None, policies: Mapping[str, LatePolicy], slugs: Iterable[str]
) -> list[Json]:
    """Return a row for each assignment that anybody handed in.

    folder    : folder of results, with a journal if `watch` wrote them
    collected : the table that `collect` wrote
    """
    everything: list[HandIn] = []
    for row in listed(collected, {*NEEDED, "from", "note"}) if collected else ():
        if form(row["from"]) and (row["file"] or row["note"] == OLDER):
            when = moment(row["when"], collected) if row["when"] else None
            everything.append((row["student"], row["assignment"], when))
    event_log = folder / JOURNAL
    for event in map(json.loads, event_log.read_bytes().splitlines() if event_log.exists() else ()):
        if event["event"] == "graded":
            arrived = datetime.fromtimestamp(event["at"]).astimezone()
            everything.append((event["student"], event["slug"], arrived))
    rows = [
        _row(slug, [hand_in for hand_in in everything if hand_in[1] == slug], policies.get(slug, LatePolicy()))
        for slug in slugs
    ]
    return [row for row in rows if row["students"]]


def _row(slug: str, hand_ins: Sequence[HandIn], policy: LatePolicy) -> Json:
    """Return statistics of how often students handed in, and of the time of each student's last hand-in."""
    attempts = Counter(student for student, *_ in hand_ins)
    last: dict[str, datetime] = {}
    for student, _, when in hand_ins:
        if when is not None:
            last[student] = max(on_the_wall(when, policy.zone), last.get(student, datetime.min))
    times = sorted(last.values())
    days = [days_between(policy.due, when, policy) for when in times] if policy.due else []
    in_time = [day for day in days if day <= 0]
    before = Counter(min(DAYS - 1, int(-day)) for day in in_time)  # whole days
    bins = [*(before[day] for day in reversed(range(DAYS))), len(days) - len(in_time)] if days else []
    return {
        "slug": slug,
        "students": len(attempts),
        "mean": f"{statistics.fmean(attempts.values()):.2g}" if attempts else "",
        "most": max(attempts.values(), default=0),
        "median": f"{times[len(times) // 2]:%Y-%m-%d %H:%M}" if times else "",
        "last_day": round(100 * sum(day > -1 for day in in_time) / len(in_time)) if in_time else "",
        "late": bins[-1] if bins else "",
        "bins": bins,
        "highest": max(bins, default=1) or 1,
    }
