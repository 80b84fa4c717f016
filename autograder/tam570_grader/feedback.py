"""What a student reads of a result, and what a teacher reads of a class; nothing of the hidden inputs."""

from collections.abc import Iterable, Sequence
from pathlib import Path

from tam570_grader.book import Record, written

__all__ = ["page", "table", "write_pages"]

SIGNS = {"passed": "+", "failed": "-", "not_run": "o", "grader_error": "!"}
HEADINGS: tuple[str, ...] = ("student", "assignment", "score", "status", "time", "what to look at first")
NOTES = {
    "missing": "Nothing was found.",
    "unreadable": "Your file could not be read.",
    "timeout": "Your file took too long.",
    "crashed": "Your file ended the process.",
}


def page(record: Record, lines: dict[str, str]) -> str:
    """A student's feedback on one assignment, as Markdown; `lines` says what each check tests."""
    head = [f"# {record['assignment']}: {_points(record['score'])} of {record['max_score']:g} points", ""]
    if note := " ".join(filter(None, (NOTES.get(record["status"]), record.get("message")))):
        head += [note, ""]
    body = []
    for part in sorted({mark["part"] for mark in record["checks"]}):
        marks = [mark for mark in record["checks"] if mark["part"] == part]
        body += [f"## Part ({part})", ""] + [_entry(mark, lines) for mark in marks] + [""]
    return "\n".join(head + body)


def _entry(mark: Record, lines: dict[str, str]) -> str:
    line = lines.get(mark["name"], mark["name"])
    entry = f"- {SIGNS[mark['outcome']]} {_points(mark['points'])}/{mark['max_points']:g} {line}"
    return (
        entry
        if mark["outcome"] == "passed"
        else f"{entry}\n  {mark['outcome'].replace('_', ' ')}: {mark['message']}"
    )


def write_pages(folder: Path, records: Iterable[Record], lines: dict[str, dict[str, str]]) -> None:
    """A page for each student and assignment, `<student>/<assignment>.md`."""
    for record in records:
        path = folder / record["student"] / f"{record['assignment']}.md"
        path.parent.mkdir(parents=True, exist_ok=True)
        written(path, page(record, lines.get(record["assignment"], {})))


def table(records: Sequence[Record]) -> str:
    """The class at a glance: a line for each submission with what to say about it first."""
    rows = [HEADINGS, *(_row(record) for record in records)]
    widths = [max(len(row[column]) for row in rows) for column in range(5)]
    return "\n".join("  ".join([*map(_padded, row[:5], widths), row[5]]).rstrip() for row in rows)


def _row(record: Record) -> tuple[str, ...]:
    score = f"{_points(record['score']):>5} / {record['max_score']:g}"
    seconds = f"{record['seconds']:.2f} s"
    return record["student"], record["assignment"], score, record["status"], seconds, _remark(record)


def _remark(record: Record) -> str:
    """The most telling thing about a result: the known mistake, else the first failure."""
    marks = [mark for mark in record["checks"] if mark["outcome"] not in ("passed", "not_run")]
    named = next((mark["suspect"] for mark in marks if mark["suspect"]), None)
    if named:
        return f"known mistake: {named}"
    unwritten = [
        mark["message"] for mark in record["checks"] if mark["message"].endswith("is not written yet")
    ]
    first = [f"{mark['name']}: {mark['message']}" for mark in marks]
    return _short(record.get("message") or next(iter([*first, *unwritten]), ""))


def _short(text: str) -> str:
    text = " ".join(text.split())
    return text if len(text) <= 90 else text[:89] + "…"


def _padded(text: str, width: int) -> str:
    return text.ljust(width)


def _points(points: float | None) -> str:
    return "?" if points is None else f"{points:g}"
