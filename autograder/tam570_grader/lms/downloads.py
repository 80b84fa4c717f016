"""The names that Canvas, Moodle and Gradescope give to what students handed in.

Canvas: "How do I download all student submissions for an assignment?" (Canvas Instructor Guide): a file is
`name_USER_ATTACHMENT_file`, with `LATE` after the name, and `-2` before the ending of a file handed in again.
Moodle: "Using Assignment", Download all submissions (docs.moodle.org): `Name_12345_assignsubmission_file_`, as a folder
or as the beginning of the file's name. Gradescope: "Exporting submissions" (Help Center): folders and
`submission_metadata.yml`, which tells the submitters of each.
"""

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

from tam570_grader.lms.archives import File

__all__ = ["READERS", "Handed", "named"]

# of a file or folder; the first that fits counts, for a student may name what is behind it like anybody's
NAMES = {
    "canvas": re.compile(
        r"(?P<name>.+?)_(?P<late>LATE_)?(?P<user>[0-9]+)_"
        r"(?:(?P<attachment>[0-9]+)_(?P<file>.+)|(?:text|link)\.html)",  # typed, or a link, on the page
        re.IGNORECASE | re.DOTALL,
    ),
    "moodle": re.compile(
        r"(?P<name>.+?)_(?P<user>[0-9]+)_assignsubmission_(?:file|onlinetext)_?(?P<file>.*)", re.DOTALL
    ),
}
AGAIN = re.compile(r"-(\d+)(?=\.\w+$)")  # what Canvas puts into the name of a file that is handed in again


@dataclass(frozen=True)
class Handed:
    """One file that one student handed in."""

    ids: tuple[str, ...]  # of the student, by each of which a roster may know them
    name: str
    file: File
    title: str  # the file's own name
    when: str = ""
    late: bool = False
    order: tuple[Any, ...] = ()  # the newest is the largest


def named(path: str, system: str) -> re.Match[str] | None:
    """The first folder or file of a path that is named as Canvas or Moodle names submissions."""
    return next(filter(None, map(NAMES[system].fullmatch, path.split("/"))), None)


def canvas(files: Iterable[File]) -> Iterator[Handed | File]:
    """Who handed in what; files that are not named as Canvas does are given back."""
    for file in _unwrapped(list(files)):
        if not (found := named(file.path, "canvas")):
            yield file
            continue
        own = found["file"] if found["file"] and file.path.endswith(found.string) else file.path.rsplit("/", 1)[-1]
        again = AGAIN.search(own)
        order = int(found["attachment"] or 0), int(again[1]) if again else 0
        title = AGAIN.sub("", own)
        yield Handed((found["user"],), found["name"], file, title, "", bool(found["late"]), order)


def _unwrapped(files: Sequence[File]) -> Sequence[File]:
    """The files without one folder around them all, whose name and date may look like a student's: `hw_2026_09_14`."""
    inner = [replace(file, path=file.path.partition("/")[2]) for file in files]
    wrapped = len({file.path.partition("/")[0] for file in files}) == 1
    return inner if wrapped and any(named(file.path, "canvas") for file in inner) else files


def moodle(files: Iterable[File]) -> Iterator[Handed | File]:
    """Who handed in what, by folders or by the beginnings of names."""
    for file in files:
        if not (found := named(file.path, "moodle")) or file.path.endswith(found.string) and not found["file"]:
            yield file
            continue
        when = file.when.isoformat(" ") if file.when else ""
        title = found["file"] if file.path.endswith(found.string) else file.path.rsplit("/", 1)[-1]
        yield Handed((found["user"], found["name"]), found["name"], file, title, when, False, (when,))


def gradescope(files: Iterable[File]) -> Iterator[Handed | File]:
    """Who handed in what, by the table of submissions; a group's file is each member's."""
    from tam570_grader.lms.gradescope_table import table_in

    held = list(files)
    table = table_in(held)
    for file in held:
        if file is table.file:
            continue
        people, when = table.of(file)
        if not people:
            yield file
        for ids, name in people:
            yield Handed(ids, name, file, file.path.rsplit("/", 1)[-1], when, False, (when,))


READERS = {"canvas": canvas, "moodle": moodle, "gradescope": gradescope}
