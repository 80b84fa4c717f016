"""Pages of feedback in a zip file that Canvas or Moodle hands out, each to the student who handed the work in.

Both know a file by the beginning of the name that they gave it in the download. Canvas: "How do I upload student
submission comments in bulk?" (Canvas Instructor Guide), whose names hold the user and the attachment. Moodle: "Upload
multiple feedback files in a zip" (docs.moodle.org, Using Assignment), whose names hold the participant.
"""

import io
import zipfile
from collections.abc import Iterator, Sequence
from pathlib import Path

from tam570_grader.errors import UsageError, printable, writing
from tam570_grader.lms.downloads import named
from tam570_grader.lms.submission_import import listed
from tam570_grader.results.tables import written
from tam570_grader.writing import assignments

__all__ = ["run"]

NEEDED = ("student", "assignment", "file", "from")  # columns of collected.csv


def run(pages: Path, collected: Path, system: str, out: Path, only: Sequence[str] | None = None) -> list[str]:
    """Write the zip file; a sentence for each of whom there is no page.

    pages     : the folder of feedback, which `grade --out` wrote
    collected : the table that `collect` wrote
    only      : names of assignments; a zip file holds the pages of one, for it is uploaded there
    """
    found = dict(_named(collected, system))
    slugs = sorted({slug for _, slug in found})
    if not found:
        raise UsageError(f"{collected} names no file as {system} does: is --to right?")
    chosen = assignments.named(only or (), slugs)
    if len(chosen) > 1:
        raise UsageError(f"the pages of one assignment make a zip file: choose with --only: {', '.join(chosen)}")
    found = {key: name for key, name in found.items() if key[1] in chosen}
    lacking, whole = [], io.BytesIO()
    with zipfile.ZipFile(whole, "w", zipfile.ZIP_DEFLATED) as archive:
        for (student, slug), name in sorted(found.items()):
            page = pages / student / f"{slug}.html"
            if page.is_file():
                archive.write(page, printable(name))
            else:
                lacking.append(f"{student} has no page of {slug}: grade it first")
    with writing(out):
        written(out, whole.getvalue())
    return lacking


def _named(collected: Path, system: str) -> Iterator[tuple[tuple[str, str], str]]:
    """Student and assignment, and the name of their page in the zip file."""
    for cells in listed(collected, NEEDED):
        start = _beginning(cells["from"], system) if cells["file"] else ""
        if start:
            yield (cells["student"], cells["assignment"]), f"{start}{cells['assignment']}.html"


def _beginning(path: str, system: str) -> str:
    """What the system put before the student's own name of the file."""
    found = named(path, system)
    if found is None:
        return ""
    if system == "moodle":
        return f"{found['name']}_{found['user']}_assignsubmission_file_"
    return found.string[: found.start("file")]  # a zip file of work is a folder there
