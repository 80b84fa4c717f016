"""Read rosters: tables of students exported from learning management systems, or plain lists.

The headings are taken from the systems' source code: Canvas `lib/gradebook_exporter.rb`, Moodle
`mod/assign/gradingtable.php` (the grading worksheet). Tables with unknown headings raise UsageError.
"""

import unicodedata
from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from tam570_grader.errors import UsageError
from tam570_grader.grading.submissions import folder_of
from tam570_grader.results.tables import table

# Headings of columns with ids, by the kind of id. A student's folder is named after the first id in the row, so logins
# come first; Moodle's participant number comes last because it differs between assignments.
KINDS = {
    "login": ("sis login id", "username", "login", "login_id"),
    "number": ("student_id", "id number", "sis user id", "sid", "student id", "orgdefinedid", "user_id"),
    "id": ("id", "canvas_user_id"),
    "email": ("email address", "email"),
    "github": ("github_username",),
    "participant": ("identifier",),
}
IDS = {heading: id_kind for id_kind, headings in KINDS.items() for heading in headings}
NAMES = ("student", "full name", "name")
PARTS = (("first name", "last name"), ("first name", "surname"), ("first_name", "last_name"), ("firstname", "lastname"))
GROUPS = ("group", "group_name", "group name", "team")
WHEN = "last modified (submission)"  # heading in Moodle's worksheet
NOT_PEOPLE = "test student"  # name of the artificial student in Canvas's student view
PARTICIPANT = "Participant "  # prefix of the number in the column Identifier of Moodle's worksheet


@dataclass(frozen=True)
class Person:
    """A student: (kind, id) pairs, of which the first names the folder, and the student's row in the table."""

    keys: tuple[tuple[str, str], ...]
    name: str
    row: Mapping[str, str]  # cells by the table's headings
    group: str = ""
    when: str = ""  # time of the submission, as text from the table

    @property
    def ids(self) -> tuple[str, ...]:
        return tuple(dict.fromkeys(value for _, value in self.keys))

    @property
    def called(self) -> str:
        return self.name or self.ids[0]

    @property
    def folder(self) -> str:
        return folder_of(self.ids[0])


def people(path: Path) -> list[Person]:
    """Return the students in a table or in a list of logins; raise UsageError if no heading of a table is known."""
    rows = table(path)
    lower = [unicodedata.normalize("NFC", text).strip().lower() for text in rows[0]]
    headings = {*IDS, *NAMES, *(part for pair in PARTS for part in pair)}
    if not headings & set(lower):
        if len(rows[0]) > 1:
            raise UsageError(
                f"{path} has the headings {', '.join(rows[0])[:300]}; none is known. Export it in English, or rename "
                f"them: {', '.join(sorted(headings))}"
            )
        lower, rows = ["login"], [["login"], *rows]
    padded = ([*row, *[""] * (len(lower) - len(row))] for row in rows[1:])
    persons = [_person(dict(zip(rows[0], row, strict=False)), dict(zip(lower, row, strict=False))) for row in padded]
    is_canvas = {"id", "section"} <= set(lower)
    return [who for who in persons if who.keys and not (is_canvas and letters(who.name) == letters(NOT_PEOPLE))]


def _person(row: Mapping[str, str], cells: Mapping[str, str]) -> Person:
    """Return the person in a row, without `keys` if it has no id; `cells` is `row` with headings in lower case."""
    name = next((cells[key].strip() for key in NAMES if cells.get(key, "").strip()), "")
    joined = (" ".join(cells[part].strip() for part in pair) for pair in PARTS if set(pair) <= cells.keys())
    name = name or next(joined, "").strip()
    extra = [("login", "student")] if "student" in cells and "section" not in cells else []  # in Canvas it is a name
    if "github_username" in cells and "identifier" in cells:  # GitHub Classroom's roster
        extra.append(("login", "identifier"))
    columns = extra + [
        (id_kind, key) for key, id_kind in IDS.items() if key in cells and key not in {used for _, used in extra}
    ]
    pairs = [(id_kind, cells[key].strip().removeprefix(PARTICIPANT).lstrip("#")) for id_kind, key in columns]
    keys = [pair for pair in pairs if pair[1]] if columns else [("login", name)] * bool(name)
    group = next((cells[key].strip() for key in GROUPS if cells.get(key, "").strip()), "")
    return Person(tuple(dict.fromkeys(keys)), name, row, group, cells.get(WHEN, "").strip())


def letters(name: str) -> str:
    """Return the letters of a name, sorted and without accents, because systems reorder its parts and drop signs."""
    plain = unicodedata.normalize("NFKD", name.casefold())
    return "".join(sorted(filter(str.isalpha, plain)))


def group_key(name: str) -> str:
    """Return the letters and digits of a group's name, as systems write it into names of files."""
    return "".join(filter(str.isalnum, unicodedata.normalize("NFKC", name.casefold())))


class Directory:
    """The people of a roster, indexed by (kind, id) and by name."""

    def __init__(self, everyone: Iterable[Person]) -> None:
        self.people = list(everyone)
        self._by: dict[tuple[str, str], list[Person]] = {}
        self._names: dict[str, list[Person]] = {}
        for person in self.people:
            for id_kind, value in person.keys:
                self._by.setdefault((id_kind, _plain(value)), []).append(person)
            if letters(person.name):
                self._names.setdefault(letters(person.name), []).append(person)
        self.kinds = {id_kind for id_kind, _ in self._by}

    def owner(self, keys: Iterable[tuple[str, str]], name: str, *, must_agree: bool) -> Person | str:
        """Return the person with these (kind, id) pairs; else the reason why there is none, "" if no row has them.

        The name is compared only if the roster has no id of these kinds. Ids that fit two people identify nobody.

        must_agree : an id counts only if `name` is its owner's name
        """
        keys = list(keys)
        fits = list({id(person): person for key in keys for person in self.of(key)}.values())
        if len(fits) > 1:
            return f"its ids are those of {' and of '.join(sorted(person.ids[0] for person in fits))}: who is it?"
        if fits and must_agree and letters(name) and letters(fits[0].name) not in ("", letters(name)):
            return (
                f"its number is {fits[0].ids[0]}'s, whose name is another; a group's work needs --groups, and Moodle's "
                "numbers the worksheet of this assignment"
            )
        if fits:
            return fits[0]
        namesakes = self._names.get(letters(name), []) if not self.kinds & {id_kind for id_kind, _ in keys} else []
        return namesakes[0] if len(namesakes) == 1 else ""

    def of(self, key: tuple[str, str]) -> list[Person]:
        """Return all persons with this (kind, id) pair."""
        return self._by.get((key[0], _plain(key[1])), [])

    @cached_property
    def by_folder(self) -> dict[str, Person]:
        """Person by possible folder name; a login has precedence over a number, an ambiguous name has no person."""
        by_name: dict[str, Person | None] = {}
        for id_kind in KINDS:
            owners: dict[str, list[Person]] = {}
            for person in self.people:
                for name in {folder_of(value) for key, value in person.keys if key == id_kind}:
                    owners.setdefault(name, []).append(person)
            for name, those in owners.items():
                by_name.setdefault(name, those[0] if len(those) == 1 else None)
        return {name: person for name, person in by_name.items() if person is not None}


def _plain(value: str) -> str:
    return unicodedata.normalize("NFC", value).casefold()


def groups(path: Path, everyone: Directory) -> dict[str, list[Person]]:
    """Return the members of each group by `group_key`, from a table with a column of GROUPS and one of ids or names."""
    members: dict[str, list[Person]] = {}
    for row in people(path):
        if row.group:
            who = everyone.owner(row.keys, row.name, must_agree=False)
            if isinstance(who, str):
                raise UsageError(f"{path}: {row.called} of group {row.group} is on no row of the roster")
            members.setdefault(group_key(row.group), []).append(who)
    return members


def students(path: Path, folders: Collection[str] = ()) -> list[str]:
    """Return each student on a roster by folder name: one of `folders` if it is theirs, else from their first id."""
    everyone = Directory(people(path))
    here = {id(everyone.by_folder[name]): name for name in folders if name in everyone.by_folder}
    return [here.get(id(person), person.folder) for person in everyone.people]


def folders(path: Path) -> set[str]:
    """Return all possible folder names of the students on a roster, one for each id."""
    return {folder_of(value) for person in people(path) for value in person.ids}


def names(path: Path) -> dict[str, str]:
    """Return the students' names by possible folder name; without students whose name is an id, as in a plain list."""
    owners = Directory(people(path)).by_folder
    return {folder: person.name for folder, person in owners.items() if person.name and person.name not in person.ids}
