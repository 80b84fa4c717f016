"""Write scores as the table that a learning management system imports, from the table that it exported."""

from collections.abc import Mapping, Sequence
from contextlib import nullcontext
from dataclasses import dataclass, field
from pathlib import Path

from tam570_grader.checks.assignments import match_slugs
from tam570_grader.errors import UsageError, warn, writing
from tam570_grader.grading import roster as rosters
from tam570_grader.grading.roster import Directory, Person
from tam570_grader.lms.systems import SYSTEMS, ScoreTable
from tam570_grader.results.manual_points import EX
from tam570_grader.results.tables import cell, name_in, table, write_table

# by (student, assignment): score (or EX) and maximum score, as text from the file
Scores = Mapping[tuple[str, str], tuple[str, str]]

KEPT = (EX, "N/A")  # cells of Canvas's gradebook that are kept: excused, and not assigned to this student


@dataclass(frozen=True)
class ExportOptions:
    """Options of the table.

    system    : a name in SYSTEMS, of a system that has a table
    roster    : the gradebook or list of participants that the system exported; students are joined by their ids
    identity  : the column by which Moodle identifies students: username, idnumber or email
    columns   : by slug, the heading or id of the column in the gradebook, from course.toml
    new       : add columns that the gradebook does not have
    overwrite : replace different scores in the gradebook
    """

    system: str
    roster: Path | None
    identity: str
    columns: Mapping[str, str]
    new: bool
    overwrite: bool


@dataclass
class Export:
    """A table to import, with sentences on excused cells that are kept, and on problems for the instructor."""

    rows: list[list[str]]
    unchanged: list[str] = field(default_factory=list)
    troubles: list[str] = field(default_factory=list)


def run(grades: Path, out: Path | None, options: ExportOptions, only: Sequence[str], absent: str) -> int:
    """Write the table for a system, or print it; return the exit code, 1 if there are problems.

    grades : grades.csv of `tam570-grader grade --out` or of `nbgrader export`
    only   : names of assignments, such as hw07; all if empty
    absent : "zero" or "blank": the score of students who did not hand in what others did

    Problems: a score of nobody on the roster, a student on it without a score, a cell that differs in the gradebook.
    """
    scores = read_scores(grades, absent)
    chosen = match_slugs(only, sorted({slug for _, slug in scores}))
    result = export({key: score for key, score in scores.items() if key[1] in chosen}, options)
    with writing(out) if out else nullcontext():
        write_table(out, result.rows, exact=True)
    for line in [*result.unchanged, *result.troubles]:
        warn(line)
    return 1 if result.troubles else 0


def export(scores: Scores, options: ExportOptions) -> Export:
    """Return the table of these scores for all students on the roster, without one for all who have a score."""
    layout = SYSTEMS[options.system].table
    assert layout is not None
    slugs = sorted({slug for _, slug in scores})
    keys = (layout.identities[options.identity],) if layout.identities else layout.keys
    roster = options.roster
    if roster is None:
        return _without_roster(scores, slugs, layout, keys)
    heading, *below = table(roster)
    heading = [name.strip() for name in heading]
    own_keys = [name for name in heading if name in keys]
    if not own_keys or (layout.identities and keys[0] not in heading):
        choose = ", or choose another --identity" if layout.identities else ""
        raise UsageError(f"the roster has no column {' or '.join(keys)}: export it with that column{choose}")
    headings = {slug: _column(layout, heading, slug, options) for slug in slugs}
    everyone = Directory(rosters.people(roster))
    result = Export([[*own_keys, *headings.values(), *layout.end[:1]]])
    if layout.possible:
        first = next((row for row in below if row and row[0].strip() == layout.possible), [])
        there = dict(zip(heading, first, strict=False))
        cells = [there.get(name, "") for name in own_keys]
        cells[0] = cells[0] or f"    {layout.possible}"
        for slug, name in headings.items():
            ours, theirs = _possible(scores, slug), there.get(name, "").strip()
            if theirs and _number(theirs) != _number(ours):
                result.troubles.append(f"{name} has {theirs} points possible in the gradebook, and {slug} has {ours}")
            cells.append(theirs or ours)
        result.rows.append(cells)
    joined = _joined(scores, everyone, result)
    for person in everyone.people:
        scored = {slug: joined.get((id(person), slug), "") for slug in slugs}
        cell_scores = {slug: layout.excused if score == EX else score for slug, score in scored.items()}
        cells = [_cell(cell_scores[slug], person, headings[slug], result, options.overwrite) for slug in slugs]
        result.rows.append([*(person.row.get(name, "") for name in own_keys), *cells, *layout.end[1:]])
    return result


def _without_roster(scores: Scores, slugs: Sequence[str], layout: ScoreTable, keys: Sequence[str]) -> Export:
    """Return the table with a row for each student, whose folder is named after the login."""
    rare = ("LastName", "FirstName", "Integration ID", "Root Account", "Last Name", "First Name", "Student ID")
    ids = [name for name in keys if name not in (*rare, "OrgDefinedId")]
    headings = [layout.heading.format(slug=slug) for slug in slugs]
    export = Export([[*ids, *headings, *layout.end[:1]]])
    if layout.possible:
        blanks = [""] * (len(ids) - 1)
        export.rows.append([f"    {layout.possible}", *blanks, *(_possible(scores, slug) for slug in slugs)])
    for student in sorted({student for student, _ in scores}):
        marked = f"{layout.prefix}{student}"  # quoted in the column of names, which is not matched
        logins = {name: cell(marked) if name == "Student" else marked for name in layout.login}
        who = [logins.get(name, marked if len(keys) == 1 else "") for name in ids]
        points = [scores.get((student, slug), ("", ""))[0].replace(EX, layout.excused) for slug in slugs]
        export.rows.append([*who, *points, *layout.end[1:]])
    return export


def _column(layout: ScoreTable, heading: Sequence[str], slug: str, options: ExportOptions) -> str:
    """Return the heading of an assignment's column, as in course.toml or from its slug; UsageError if it is unclear."""
    wanted = options.columns.get(slug, slug)
    if not layout.must_match:
        return wanted
    others = [match for name in heading if name not in layout.keys and (match := layout.column.fullmatch(name))]
    # course.toml may name a column by its heading, or by the title or the id in it
    fits = [match[0] for match in others if wanted in (match[0], *map(match.groupdict().get, ("title", "id")))]
    if len(fits) == 1:
        return fits[0]
    listed = "; ".join(match[0] for match in others[:40]) or "none"
    if fits:
        raise UsageError(
            f"{len(fits)} columns of the gradebook fit {slug}: write the id of one into course.toml: {listed}"
        )
    if options.new and slug not in options.columns:
        return layout.heading.format(slug=slug)
    raise UsageError(
        f"the gradebook has no column {wanted}. Its columns: {listed}. Write which one is {slug}'s into course.toml, "
        f'as [{slug[:4]}] {options.system} = "...", or make a new assignment with --new'
    )


def _joined(scores: Scores, everyone: Directory, export: Export) -> dict[tuple[int, str], str]:
    """Return the scores by person and assignment; report students without a row or a score in `export.troubles`."""
    joined: dict[tuple[int, str], str] = {}
    unmatched = sorted({student for student, _ in scores} - everyone.by_folder.keys())
    for (student, slug), (score, _) in scores.items():
        if person := everyone.by_folder.get(student):
            key = id(person), slug
            if key in joined and joined[key] != score:
                raise UsageError(f"two folders are {person.ids[0]}'s and have other scores in {slug}: keep one of them")
            joined[key] = score
    export.troubles += [
        f"{name} has scores and is on no row of the roster: add a row, or rename the folder" for name in unmatched
    ]
    export.troubles += [
        f"{person.called} ({person.ids[0]}) has no score in {slug}: does collected.csv say why?"
        for person in everyone.people
        for slug in sorted({slug for _, slug in scores})
        if not joined.get((id(person), slug))
    ]
    return joined


def _cell(ours: str, person: Person, column: str, export: Export, overwrite: bool) -> str:
    """Return our score, or the gradebook's cell if it must be kept: excused, not assigned, or changed there."""
    theirs = person.row.get(column, "").strip()
    if theirs.upper() in KEPT:
        if ours not in ("", theirs.upper()):
            export.unchanged.append(f"{person.called} is {theirs} in {column}, and stays so: the grader has {ours}")
        return theirs
    if not ours or not theirs or overwrite or _number(theirs) == _number(ours):
        return ours or theirs
    export.troubles.append(
        f"{person.called} keeps {theirs} in {column}; the grader has {ours}, which --overwrite takes"
    )
    return theirs


def _number(text: str) -> float | str:
    """Return a number, with decimal point or comma, rounded as in the gradebook; other text unchanged."""
    try:
        return round(float(text.replace(",", ".")), 2)
    except ValueError:
        return text


def _possible(scores: Scores, slug: str) -> str:
    return next(largest for (_, assignment), (_, largest) in scores.items() if assignment == slug)


def read_scores(grades: Path, absent: str) -> Scores:
    """Return the scores in our table or nbgrader's; "" if the grader failed, or for the absent if `absent` is "blank".

    nbgrader gives everybody zero for an assignment that was released and not collected; such scores become "".
    """
    heading, *rows = table(grades)
    name = "student" if "student" in heading else "student_id"
    if not {name, "assignment", "score", "max_score"} <= set(heading):
        raise UsageError(f"{grades} is not a grades.csv of tam570-grader or nbgrader")
    if odd := [",".join(row) for row in rows if len(row) != len(heading)]:
        raise UsageError(
            f"{grades} has a row that does not fit its heading of {len(heading)} columns: {odd[0]}; mend it"
        )
    records = [dict(zip(heading, row, strict=True)) for row in rows]
    true_name = name_in if name == "student" else str  # nbgrader does not quote formulas
    if "timestamp" in heading:
        here = {row["assignment"] for row in records if row["timestamp"] or float(row["score"] or 0)}
        records = [row if row["assignment"] in here else {**row, "score": ""} for row in records]
    if absent == "blank":
        for row in records:
            nothing = row["status"] == "missing" if "status" in row else not row.get("timestamp", "unknown")
            if nothing and row["score"] != EX and not float(row["score"] or 0):  # and no points by hand
                row["score"] = ""
    return {(true_name(row[name]), row["assignment"]): (row["score"], row["max_score"]) for row in records}
