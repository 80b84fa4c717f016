"""Compare the scores of a new run with an old one's, check by check."""

from collections.abc import Container, Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from tam570_grader.checks.assignments import slug_of
from tam570_grader.grading.submissions import Submission
from tam570_grader.results.store import Key, Record, key_of


@dataclass(frozen=True)
class Change:
    """A changed score; None means no score or no submission."""

    student: str
    assignment: str
    old: float | None
    new: float | None
    because: tuple[str, ...]  # one line for each difference: missing before, status, points of a check


def change(old: Record | None, new: Record) -> Change | None:
    """Return the change from an old record to the new one; None if the score is the same."""
    before = old["score"] if old else None
    if old and before == new["score"]:
        return None
    because = [] if old else ["not in the old results"]
    if old:
        if old["status"] != new["status"]:
            because.append(f"{old['status']} -> {new['status']}")
        was, now = ({check["name"]: check for check in record["checks"]} for record in (old, new))
        because += [  # includes checks that exist in only one of the records
            f"{name}: {_shown(was.get(name))} -> {_shown(now.get(name))}"
            for name in {**was, **now}
            if _points(was.get(name)) != _points(now.get(name))
        ]
    return Change(new["student"], new["assignment"], before, new["score"], tuple(because))


def gone(
    old: Mapping[Key, Record], submissions: Sequence[Submission], paths: Iterable[Path], slugs: Container[str]
) -> list[Change]:
    """Return changes for old results without a submission now; of absent students only if a path is a whole class."""
    folders = {path.absolute() for path in paths}
    present = [submission for submission in submissions if submission.tree.parent in folders]
    is_tree = any(slug_of(submission.tree.name, [submission.slug]) is None for submission in present)
    students = {submission.student for submission in present}
    here = {submission.key for submission in submissions}
    return [
        Change(record["student"], record["assignment"], record["score"], None, ("no longer handed in",))
        for record in old.values()
        if key_of(record) not in here and record["assignment"] in slugs and (is_tree or record["student"] in students)
    ]


def _points(check: Record | None) -> tuple[float | None, float] | None:
    return (check["points"], check["max_points"]) if check else None


def _shown(check: Record | None) -> str:
    if check is None:
        return "no such check"
    return f"{check['outcome'].replace('_', ' ')} {_number(check['points'])}/{check['max_points']:g}"


def table(changes: Iterable[Change], compared: int) -> str:
    """Return the changes as text, the largest first."""
    ordered = sorted(changes, key=lambda change: (-abs(_difference(change)), change.assignment, change.student))
    if not ordered:
        return f"no score changes ({compared} compared)"
    lines = [f"{len(ordered)} of {compared} scores change"]
    for change in ordered:
        gain = f"{_difference(change):+g}" if None not in (change.old, change.new) else "?"
        lines.append(f"{change.student}  {change.assignment}  {_number(change.old)} -> {_number(change.new)}  ({gain})")
        lines += [f"    {why}" for why in change.because]
    return "\n".join(lines)


def _difference(change: Change) -> float:
    return round((change.new or 0.0) - (change.old or 0.0), 6)


def _number(points: float | None) -> str:
    return "none" if points is None else f"{points:g}"
