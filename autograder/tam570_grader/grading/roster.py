"""Who takes the course: the tables of students that Canvas, Moodle and Gradescope export, or a plain list.

Canvas: "How do I export grades in the Gradebook?" and "How do I import grades in the Gradebook?" (Canvas Instructor
Guide). Moodle: "Grade export" and "Assignment settings", offline grading worksheet (docs.moodle.org). Gradescope:
"Adding and editing your roster" (Gradescope Help Center).
"""

from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path

from tam570_grader.grading.submissions import folder_of
from tam570_grader.results.tables import table

__all__ = ["NOT_PEOPLE", "Person", "by_id", "folders", "people", "students", "table"]

# columns that tell people apart, the login first: what their folders are named after;
# the number of a participant is last, for it is another in every course
IDS = (
    "sis login id",
    "username",
    "login",
    "student_id",
    "id number",
    "sis user id",
    "sid",
    "id",
    "email address",
    "email",
    "identifier",
)
NAMES = ("student", "full name", "name")
PARTS = (("first name", "last name"), ("first name", "surname"), ("first_name", "last_name"))
NOT_PEOPLE = ("student, test",)  # Canvas makes this one to try things out; rows that are not students have no number
PARTICIPANT = "Participant "  # before the number, in the column Identifier of Moodle's worksheet


@dataclass(frozen=True)
class Person:
    """One student: all that the system knows them by, the login first, and their row in the table."""

    ids: tuple[str, ...]
    name: str
    row: Mapping[str, str]  # by the table's own headings


def people(path: Path) -> list[Person]:
    """The students in a table with a heading that Canvas, Moodle or Gradescope writes, or in a list, one a line."""
    rows = table(path)
    lower = [heading.strip().lower() for heading in rows[0]]
    known = {*IDS, *NAMES, *(part for pair in PARTS for part in pair)}
    if not known & set(lower):
        return [Person((row[0].strip(),), row[0].strip(), {}) for row in rows if row[0].strip()]
    padded = ([*row, *[""] * (len(lower) - len(row))] for row in rows[1:])
    found = [_person(dict(zip(rows[0], row, strict=False)), dict(zip(lower, row, strict=False))) for row in padded]
    return [one for one in found if one.ids and one.name.lower() not in NOT_PEOPLE]


def _person(row: Mapping[str, str], cells: Mapping[str, str]) -> Person:
    """What a row tells, by its headings in small letters; a Canvas row without a number is not a student's."""
    name = next((cells[key].strip() for key in NAMES if cells.get(key, "").strip()), "")
    joined = (" ".join(cells[part].strip() for part in pair) for pair in PARTS if set(pair) <= cells.keys())
    name = name or next(joined, "").strip()
    own = ["student"] if "student" in cells and "section" not in cells else []  # in Canvas's table it is a name
    columns = own + [key for key in IDS if key in cells]
    ids = [cells[key].strip().removeprefix(PARTICIPANT) for key in columns] if columns else [name]
    return Person(tuple(dict.fromkeys(filter(None, ids))), name, row)


def by_id(found: Iterable[Person]) -> dict[str, Person]:
    """Each student by each of their ids; an id shared by two is left out; a unique full name counts as an id."""
    count: dict[str, list[Person]] = {}
    for one in found:
        for key in {*one.ids, one.name} - {""}:
            count.setdefault(key, []).append(one)
    return {key: owners[0] for key, owners in count.items() if len(owners) == 1}


def students(path: Path, known: Collection[str] = ()) -> list[str]:
    """The students on a roster, as their folders are named: by the id that is known already, else by their login."""
    names = [[*map(folder_of, one.ids)] for one in people(path)]
    return [next((name for name in own if name in known), own[0]) for own in names]


def folders(path: Path) -> set[str]:
    """The names that the folders of the students on a roster may have."""
    return {folder_of(key) for one in people(path) for key in one.ids}
