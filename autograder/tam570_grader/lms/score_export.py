"""Scores for a learning management system: tables that Canvas and Moodle import.

Canvas: "How do I import grades in the Gradebook?" (Canvas Instructor Guide). Moodle: "Grade import" (docs.moodle.org).
"""

import csv
import io
from collections.abc import Mapping, Sequence
from pathlib import Path

from tam570_grader.errors import UsageError, warn, writing
from tam570_grader.grading import roster as rosters
from tam570_grader.grading.submissions import folder_of
from tam570_grader.results.tables import FORMULA, cell, name_in, written
from tam570_grader.writing.assignments import named

__all__ = ["canvas", "moodle", "moodle_of", "run"]

# (student, assignment): score and largest score, as in the file
Scores = Mapping[tuple[str, str], tuple[str, str]]

# what Canvas knows a student by, in its order
CANVAS = ("Student", "ID", "SIS User ID", "SIS Login ID", "Section")
POSSIBLE = "    Points Possible"  # the name, with its blanks, of the row below the heading
# as Moodle's own export says
MOODLE = {"username": "Username", "idnumber": "ID number", "email": "Email address"}


def run(
    grades: Path,
    system: str,
    roster: Path | None,
    identity: str,
    out: Path | None,
    only: Sequence[str] | None = None,
    absent: str = "zero",
) -> int:
    """Write the table for Canvas or Moodle; the exit code.

    grades   : grades.csv, of `tam570-grader grade --out` or of `nbgrader export`
    roster   : a gradebook exported from Canvas, or a table of Moodle's participants: students are joined by their ids
    identity : what Moodle shall know students by: username, idnumber or email
    only     : names of assignments, hw07 say; default: all
    absent   : zero, or blank, for who did not hand in what others did

    With a roster the exit code is 1 if a score belongs to nobody on it, or somebody on it has no score.
    """
    found = _only(_scores(grades, absent), only or ())
    people = rosters.people(roster) if roster else []
    if system == "moodle":
        table = moodle_of(found, people, identity) if roster else moodle(found, identity)
    else:
        table = canvas(found, rosters.table(roster) if roster else None)
    _warn_of_formulas(table)
    text = io.StringIO()
    csv.writer(text).writerows(table)
    if out:
        with writing(out):
            written(out, text.getvalue())
    else:
        print(text.getvalue(), end="")
    left = _left(found, people) if roster else []
    for line in left:
        warn(line)
    return 1 if left else 0


def _only(scores: Scores, names: Sequence[str]) -> Scores:
    """The scores of the assignments that are named; all if there are no names."""
    chosen = named(names, sorted({slug for _, slug in scores}))
    return {key: score for key, score in scores.items() if key[1] in chosen}


def _left(scores: Scores, people: Sequence[rosters.Person]) -> list[str]:
    """Scores without a student and students without a score: a sentence for each."""
    ids = {folder_of(key) for one in people for key in one.ids}
    strangers = sorted({student for student, _ in scores} - ids)
    scored = {key for key, (score, _) in scores.items() if score}
    slugs = sorted({slug for _, slug in scores})
    lacking = [
        f"{one.name or one.ids[0]} ({one.ids[0]}) has no score in {slug}"
        for one in people
        for slug in slugs
        if not any((folder_of(key), slug) in scored for key in one.ids)
    ]
    return [
        f"{name} has scores and is on no row of the roster: add a row, or rename the folder" for name in strangers
    ] + lacking


def _warn_of_formulas(table: Sequence[Sequence[str]]) -> None:
    """A login is matched only as it is, so none is quoted."""
    if found := sorted({text for row in table for text in row if text.startswith(FORMULA)}):
        names = ", ".join(map(repr, found))
        says = "import the table without opening it in a spreadsheet, which may take these for formulas"
        warn(f"{says}: {names}")


def canvas(scores: Scores, roster: Sequence[Sequence[str]] | None = None) -> list[list[str]]:
    """The table for Canvas: its five columns, one for each assignment; a column that Canvas knows keeps its number."""
    slugs = sorted({slug for _, slug in scores})
    heading, people = _people(roster) if roster else ([*CANVAS], _unknown(scores))
    columns = [next((name for name in heading[5:] if name.split(" (")[0] == slug), slug) for slug in slugs]
    possible = [POSSIBLE, "", "", "", "", *(_possible(scores, slug) for slug in slugs)]
    rows = [[*person[:5], *(_score(scores, person, slug) for slug in slugs)] for person in people]
    return [[*CANVAS, *columns], possible, *rows]


def moodle(scores: Scores, identity: str = "username") -> list[list[str]]:
    """The table for Moodle: who it is by one of Moodle's fields, and a column for each assignment."""
    slugs = sorted({slug for _, slug in scores})
    students = sorted({student for student, _ in scores})
    rows = [[student, *(scores.get((student, slug), ("", ""))[0] for slug in slugs)] for student in students]
    return [[MOODLE[identity], *slugs], *rows]


def moodle_of(scores: Scores, people: Sequence[rosters.Person], identity: str) -> list[list[str]]:
    """The table for Moodle with a row for each participant, by the field that the import is mapped to.

    Moodle: "Grade import" (docs.moodle.org): one column identifies the user, the others are grade items.
    """
    slugs, heading = sorted({slug for _, slug in scores}), MOODLE[identity]
    if any(heading not in one.row for one in people):
        raise UsageError(
            f"the roster has no column {heading}: export it with that column, or choose another --identity"
        )
    rows = [[one.row[heading].strip(), *(_first(scores, one.ids, slug) for slug in slugs)] for one in people]
    return [[heading, *slugs], *rows]


def _scores(grades: Path, absent: str) -> Scores:
    """The scores in our table or nbgrader's; empty where the grader itself failed, or, if asked for, of the absent.

    nbgrader has zeros for everybody on what was released and not collected: nobody handed that in, and none is scored.
    """
    heading, *rows = rosters.table(grades)
    name = "student" if "student" in heading else "student_id"
    if not {name, "assignment", "score", "max_score"} <= set(heading):
        raise UsageError(f"{grades} is not a grades.csv of tam570-grader or nbgrader")
    if odd := [",".join(row) for row in rows if len(row) != len(heading)]:
        raise UsageError(
            f"{grades} has a row that does not fit its heading of {len(heading)} columns: {odd[0]}; mend it"
        )
    found = [dict(zip(heading, row, strict=True)) for row in rows]
    true_name = name_in if name == "student" else str  # nbgrader quotes none
    if "timestamp" in heading:
        here = {row["assignment"] for row in found if row["timestamp"] or float(row["score"] or 0)}
        found = [row if row["assignment"] in here else {**row, "score": ""} for row in found]
    if absent == "blank":
        found = [{**row, "score": ""} if _is_absent(row) else row for row in found]
    return {(true_name(row[name]), row["assignment"]): (row["score"], row["max_score"]) for row in found}


def _is_absent(row: Mapping[str, str]) -> bool:
    """Whether nothing was handed in, and nothing given by hand."""
    nothing = row["status"] == "missing" if "status" in row else not row.get("timestamp", "unknown")
    return nothing and not float(row["score"] or 0)


def _people(roster: Sequence[Sequence[str]]) -> tuple[list[str], list[Sequence[str]]]:
    """The heading of Canvas's export and the rows of students in it, without its notes."""
    heading = list(roster[0])
    if tuple(heading[:5]) != CANVAS:
        raise UsageError(f"the roster is not a gradebook of Canvas: its columns must begin with {', '.join(CANVAS)}")
    return heading, [row for row in roster[1:] if len(row) >= 5 and _is_student(row)]


def _is_student(row: Sequence[str]) -> bool:
    return any(cell.strip() for cell in row[1:4]) and row[0].strip().lower() not in rosters.NOT_PEOPLE


def _unknown(scores: Scores) -> list[Sequence[str]]:
    """Students of whom we know no more than the name of their folder, taken for their login."""
    return [[cell(student), "", "", student, ""] for student in sorted({student for student, _ in scores})]


def _score(scores: Scores, person: Sequence[str], slug: str) -> str:
    """A person's score, by login or numbers; "" leaves what Canvas has."""
    return _first(scores, [name.strip() for name in (person[3], person[2], person[1]) if name.strip()], slug)


def _first(scores: Scores, names: Sequence[str], slug: str) -> str:
    """The score of whoever goes by one of these names."""
    return next((scores[name, slug][0] for name in map(folder_of, names) if (name, slug) in scores), "")


def _possible(scores: Scores, slug: str) -> str:
    return next(largest for (_, one), (_, largest) in scores.items() if one == slug)
