"""The names that Canvas, Moodle and Gradescope give to what students handed in.

Canvas: "How do I download all student submissions for an assignment?" (Canvas Instructor Guide): a file is
`name_USER_ATTACHMENT_file`, with `LATE` after the name, and `-2` before the ending of a file handed in again.
Moodle: "Using Assignment", Download all submissions (docs.moodle.org): `Name_12345_assignsubmission_file_`, as a folder
or as the beginning of the file's name. Gradescope: "Exporting submissions" (Help Center): folders and
`submission_metadata.yml`, which tells the submitters of each.
"""

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from tam570_grader.delivery.archives import File
from tam570_grader.errors import UsageError

__all__ = ["READERS", "Handed"]

CANVAS = re.compile(r"(?P<name>.+?)_(?P<late>LATE_)?(?P<user>\d+)_(?P<attachment>\d+)_(?P<file>.+)", re.IGNORECASE)
AGAIN = re.compile(r"-(\d+)(?=\.\w+$)")  # what Canvas puts into the name of a file that is handed in again
MOODLE = re.compile(r"(?P<name>[^/]+)_(?P<user>\d+)_assignsubmission_(?:file|onlinetext)_?/?(?P<file>.*)")
METADATA = "submission_metadata.yml"


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


def canvas(files: Iterable[File]) -> Iterator[Handed | File]:
    """Who handed in what; files that are not named as Canvas does are given back."""
    for file in files:
        if not (found := CANVAS.fullmatch(file.path.rsplit("/", 1)[-1])):
            yield file
            continue
        again = AGAIN.search(found["file"])
        order = int(found["attachment"]), int(again[1]) if again else 0
        title = AGAIN.sub("", found["file"])
        yield Handed((found["user"],), found["name"], file, title, "", bool(found["late"]), order)


def moodle(files: Iterable[File]) -> Iterator[Handed | File]:
    """Who handed in what, by folders or by the beginnings of names."""
    for file in files:
        if not (found := MOODLE.search(file.path)) or not found["file"]:
            yield file
            continue
        when = file.when.isoformat(" ") if file.when else ""
        title = found["file"].rsplit("/", 1)[-1]
        yield Handed((found["user"], found["name"]), found["name"], file, title, when, False, (when,))


def gradescope(files: Iterable[File]) -> Iterator[Handed | File]:
    """Who handed in what, by the table of submissions; a group's file is each member's."""
    held = list(files)
    submissions = _metadata(held)
    for file in held:
        folder = next((part for part in file.path.split("/")[:-1] if part in submissions), None)
        if file.path.endswith(METADATA):
            continue
        if folder is None:
            yield file
            continue
        when = str(submissions[folder].get(":created_at") or "")
        for who in submissions[folder].get(":submitters") or []:
            ids = tuple(str(who[key]) for key in (":sid", ":email") if who.get(key))
            name = str(who.get(":name") or "")
            yield Handed((*ids, name), name, file, file.path.rsplit("/", 1)[-1], when, False, (when,))


def _metadata(files: Iterable[File]) -> Mapping[str, Any]:
    import yaml

    text = next((file.data for file in files if file.path.endswith(METADATA)), None)
    if text is None:
        raise UsageError(f"the export holds no {METADATA}: choose Export Submissions in Gradescope")
    try:
        found = yaml.load(text, Loader=yaml.BaseLoader)  # BaseLoader: every leaf stays text, as 007 must
    except yaml.YAMLError as error:
        raise UsageError(f"{METADATA} cannot be read: {error}; export the submissions again") from None
    if not isinstance(found, dict):
        raise UsageError(f"{METADATA} lists no submissions; export them again")
    return found


READERS = {"canvas": canvas, "moodle": moodle, "gradescope": gradescope}
