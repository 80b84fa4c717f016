"""Read `submission_metadata.yml`, the table of submissions in Gradescope's export, and check all of it."""

import io
import re
from collections.abc import Iterable
from dataclasses import replace
from typing import Any

import yaml

from tam570.notebooks import LARGEST
from tam570_grader.errors import UsageError
from tam570_grader.grading.archives import METADATA, File

FOLDER = re.compile(r"submission_[0-9]+")  # name of a submission's folder
WANTED = (b"  :submitters:", b"  :created_at:")
AGAIN = "export the submissions again in Gradescope"
People = tuple[tuple[dict[str, str], str], ...]  # the ids of each submitter, and the name


def table_in(files: Iterable[File]) -> tuple[File, dict[str, tuple[People, str]]]:
    """Return the class's table, and the submitters and time of each folder beside it.

    It is the outermost file of that name, because a student may hand in another.
    """
    tables = [file for file in files if file.path.rsplit("/", 1)[-1] == METADATA]
    outside = [file for file in tables if not any(map(FOLDER.fullmatch, file.path.split("/")))]  # not in a submission
    file = min(outside, key=lambda file: file.path.count("/"), default=None)
    if file is None:
        raise UsageError(f"the export holds no {METADATA} beside its submissions: {AGAIN}, by Export Submissions")
    if file.refused:
        raise UsageError(f"{file.path} cannot be read: {file.refused}; {AGAIN}")
    entries = _read(file if len(file.data) <= LARGEST else replace(file, data=_without_results(file.data)))
    if not isinstance(entries, dict) or not entries:
        size = f", and is larger than {LARGEST // 2**20} MiB" if len(file.data) > LARGEST else ""
        raise UsageError(f"{file.path} lists no submissions{size}; {AGAIN}")
    beside, submissions = file.path.removesuffix(METADATA), {}
    for folder, entry in entries.items():
        where = f"{file.path}, {folder}"
        fields = entry if isinstance(entry, dict) else {":submitters": "none"}
        submitters, when = fields.get(":submitters") or [], fields.get(":created_at", "")
        if not isinstance(submitters, list) or not isinstance(when, str):
            raise UsageError(f"{where}: this is not what Gradescope writes of a submission; {AGAIN}")
        submissions[f"{beside}{folder}"] = tuple(_person(who, where) for who in submitters), when
    return file, submissions


def _without_results(data: bytes) -> bytes:
    """Return the lines of a long table with folders, submitters and times, without the outputs."""
    lines, is_wanted = list[bytes](), False
    for line in io.BytesIO(data):
        if not line.startswith(b" "):
            is_wanted = True
        elif line.startswith(b"  :"):
            is_wanted = line.startswith(WANTED)
        if is_wanted:
            lines.append(line)
    return b"".join(lines)


def _read(file: File) -> object:
    try:
        return yaml.load(file.data, Loader=_Plain)
    except (yaml.YAMLError, ValueError) as error:
        raise UsageError(f"{file.path} cannot be read: {' '.join(str(error).split())}; {AGAIN}") from None
    except (RecursionError, MemoryError):
        raise UsageError(f"{file.path} cannot be read: its parts lie too deep in one another; {AGAIN}") from None


def _person(who: object, where: str) -> tuple[dict[str, str], str]:
    ids = {key: who.get(f":{key}") or "" for key in ("sid", "email", "name")} if isinstance(who, dict) else {}
    if not any(ids.values()) or not all(isinstance(value, str) for value in ids.values()):
        raise UsageError(f"{where}: a submitter has neither id nor email nor name; {AGAIN}")
    return ids, ids["name"]


class _Plain(yaml.BaseLoader):  # type: ignore[misc]  # yaml has no types
    """A YAML loader that keeps every scalar as text (007) and allows aliases only of scalars: no expansion bombs."""

    def compose_node(self, parent: object, index: object) -> Any:
        is_alias = self.check_event(yaml.AliasEvent)
        node = super().compose_node(parent, index)
        if is_alias and not isinstance(node, yaml.ScalarNode):
            raise yaml.YAMLError("it has aliases of whole parts, which Gradescope does not write")
        return node
