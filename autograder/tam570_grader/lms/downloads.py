"""Find out who handed in each file of a download: from a system's names of files, its table, or its folders."""

import os
import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from datetime import datetime

from dateutil import parser as dates  # type: ignore[import-untyped]

from tam570_grader.grading.archives import File, is_beside
from tam570_grader.lms.systems import SYSTEMS, System
from tam570_grader.results.collected import form, is_zip

RELEASED = ("README.md", "figure.svg", "NOTATION.md")  # files of the assignment in each repository
AGAIN = re.compile(r"-(\d{1,9})(?=\.\w+$)")  # Canvas's number in the name of a file that is handed in again


@dataclass(frozen=True)
class Handed:
    """A file that a student or group handed in."""

    keys: tuple[tuple[str, str], ...]  # (kind, id) pairs to find the student on a roster
    name: str
    file: File
    title: str  # the student's name of the file
    when: str = ""
    late: bool = False
    order: tuple[int, int, str] = (0, 0, "")  # larger for newer files

    @property
    def who(self) -> str:
        """The student's first id, or name if there is no id; used without a roster."""
        return self.keys[0][1] if self.keys else self.name


def read(files: Iterable[File], name: str) -> Iterator[Handed | File]:
    """Yield a Handed for each file whose student the system's names or table tell, the other files as they are."""
    system, held = SYSTEMS[name], list(files)
    if name == "gradescope":
        return _of_table(held, system)
    return _of_repositories(held, system) if system.download is None else _of_names(held, system)


def fields_of(path: str, system: System) -> dict[str, str] | None:
    """Return the fields of the first part of a path with the system's form (later parts are the student's), or None."""
    for part in path.split("/"):
        if system.download and (match := system.download.fullmatch(part)):
            fields = {key.rstrip("2"): text or "" for key, text in match.groupdict().items() if text is not None}
            return {"name": "", **fields, "whole": part}
    return None


def _of_names(files: Sequence[File], system: System) -> Iterator[Handed | File]:
    # A folder around all files is removed: its name, for example `hw_2026_09_14`, may look like a student's.
    if system is SYSTEMS["canvas"] and len({file.path.partition("/")[0] for file in files}) == 1:
        inner = [replace(file, path=file.path.partition("/")[2]) for file in files]
        files = inner if any(fields_of(file.path, system) for file in inner) else files
    each = [fields_of(file.path, system) for file in files]
    # Blackboard writes the assignment's title before the login, and both may contain underscores
    titled = {f"{fields['title']}_{fields['user']}" for fields in each if fields and "title" in fields}
    common = os.path.commonprefix(sorted(titled)).rpartition("_")[0]
    for file, fields in zip(files, each, strict=True):
        if fields and "title" in fields and common:
            fields["user"] = f"{fields['title']}_{fields['user']}".removeprefix(f"{common}_")
        is_file = fields is not None and file.path.endswith(fields["whole"])
        if fields is None or (is_file and not fields.get("file") and not file.path.endswith((".html", ".txt"))):
            yield file
            continue
        name = fields["file"] if is_file and fields.get("file") else file.path.rsplit("/", 1)[-1]
        version = AGAIN.search(name) if fields.get("order") else None
        when = _moment(fields["when"]) if "when" in fields else ""
        order = (int(fields.get("order") or 0), int(version[1]) if version else 0, when)
        keys = tuple((key, fields[group]) for group, kinds in system.ids.items() if group in fields for key in kinds)
        title = AGAIN.sub("", name) if version else name
        yield Handed(keys, fields["name"], file, title, when, bool(fields.get("late")), order)


def _moment(text: str) -> str:
    """Return a time in a file's name, `2026-09-14-23-59-00` or `Sep 14, 2026 1159 PM`, in ISO format; else ""."""
    plain = re.sub(r"^(\d{4}-\d\d-\d\d)-(\d\d)-(\d\d)-(\d\d)$", r"\1 \2:\3:\4", text)
    plain = re.sub(r"(\d{4}) (\d{1,2}):?(\d\d) ([AP]M)$", r"\1 \2:\3 \4", plain)
    return time_of(plain)


def time_of(text: str, *, day_first: bool = True) -> str:
    """Return a time in a table in ISO format; "" for other text, for example in another language."""
    try:
        moment: datetime = dates.parse(text, dayfirst=day_first and not re.match(r"\d{4}", text))
    except (ValueError, OverflowError):
        return ""
    return moment.isoformat(" ")


def _of_repositories(files: Sequence[File], system: System) -> Iterator[Handed | File]:
    """Yield the work in folders `assignment-user`, where the assignment is the common prefix of all names."""
    parts = [file.path.split("/") for file in files]
    if len({path[0] for path in parts}) == 1 and all(len(path) > 2 for path in parts):
        parts = [path[1:] for path in parts]  # without the folder that `gh classroom` makes around them
    start = os.path.commonprefix(sorted({path[0] for path in parts}))
    start = start[: start.rfind("-") + 1]
    for file, path in zip(files, parts, strict=True):
        user = path[0].removeprefix(start)
        if len(path) == 1 or not user:
            yield file
        elif _is_handed_in(path[-1]) and not any(part.startswith(".") for part in path):
            keys = tuple((key, user) for kinds in system.ids.values() for key in kinds)
            yield Handed(keys, "", file, path[-1])


def _is_handed_in(name: str) -> bool:
    """Return whether a file of a repository is a student's work, a zip file, or a drawing or text beside the work."""
    return name not in RELEASED and (bool(form(name)) or is_zip(name) or is_beside(name))


def _of_table(files: Sequence[File], system: System) -> Iterator[Handed | File]:
    """Yield the files with their students from Gradescope's table; a group's file once for each member."""
    from tam570_grader.lms.gradescope_table import table_in

    table, submissions = table_in(files)
    depth = table.path.count("/") + 1
    for file in files:
        if file is table:
            continue
        people, when = submissions.get("/".join(file.path.split("/")[:depth]), ((), ""))
        if not people:
            yield file
        for ids, name in people:
            keys = tuple((key, ids[field]) for field, kinds in system.ids.items() if ids[field] for key in kinds)
            yield Handed(keys, name, file, file.path.rsplit("/", 1)[-1], when, False, (0, 0, when))
