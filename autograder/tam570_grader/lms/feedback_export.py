"""Write feedback pages into a zip file that a system distributes to the students.

The system matches a page to a student by the prefix of the name that it gave to the submitted file: Canvas by user and
attachment, Moodle by participant (`mod/assign/feedback/file/importziplib.php`).
"""

import io
import zipfile
from collections.abc import Mapping, Sequence
from pathlib import Path

from tam570_grader.checks import assignments
from tam570_grader.errors import UsageError, printable, writing
from tam570_grader.grading import roster as rosters
from tam570_grader.lms.downloads import fields_of
from tam570_grader.lms.systems import SYSTEMS
from tam570_grader.results.collected import form, listed
from tam570_grader.results.tables import written

NEEDED = ("student", "assignment", "file", "from")  # columns of collected.csv


def run(pages: Path, collected: Path, system: str, out: Path, only: Sequence[str], roster: Path | None) -> list[str]:
    """Write the zip file; return a sentence for each student without a page.

    pages     : the folder of feedback that `grade --out` wrote
    collected : the table that `collect` wrote
    only      : names of assignments, which must choose one, as a zip file is uploaded to one assignment
    roster    : Moodle's worksheet, with which each member of a group gets a page
    """
    page_name = SYSTEMS[system].page
    if page_name is None:
        raise UsageError(f"{SYSTEMS[system].title} takes no zip file of pages: hand back the folder {pages}")
    everyone = rosters.Directory(rosters.people(roster) if roster else ())
    names = _named(listed(collected, NEEDED), system, page_name, everyone)
    slugs = sorted({slug for _, slug in names})
    if not names:
        raise UsageError(f"{collected} names no file as {system} does: is --to right?")
    chosen = assignments.match_slugs(only, slugs)
    if len(chosen) > 1:
        raise UsageError(f"the pages of one assignment make a zip file: choose with --only: {', '.join(chosen)}")
    lacking, data, there = [], io.BytesIO(), set()
    with zipfile.ZipFile(data, "w", zipfile.ZIP_DEFLATED) as archive:
        for (student, slug), (name, is_collected) in sorted(names.items()):
            page = pages / student / f"{slug}.html"
            if slug in chosen and page.is_file() and name not in there:  # a group has one file and one page
                archive.write(page, printable(name))
                there.add(name)
            elif slug in chosen and is_collected and not page.is_file():
                lacking.append(f"{student} has no page of {slug}: grade it first")
    with writing(out):
        written(out, data.getvalue())
    return lacking


def _named(
    rows: Sequence[Mapping[str, str]], system: str, page: str, everyone: rosters.Directory
) -> dict[tuple[str, str], tuple[str, bool]]:
    """Return by student and assignment the name of the page, also for a lone PDF, and whether work was collected."""
    names: dict[tuple[str, str], tuple[str, bool]] = {}
    for cells in sorted(rows, key=lambda cells: not form(cells["file"])):
        student, slug = cells["student"], cells["assignment"]
        fields = fields_of(cells["from"], SYSTEMS[system])
        if not slug or fields is None or (system == "canvas" and "start" not in fields):
            continue
        person = everyone.by_folder.get(student)
        participant = dict(person.keys).get("participant") if person else None
        if person and participant and system == "moodle":  # a group's number is not a participant's
            fields |= {"name": person.name.replace("_", " ") or fields["name"], "user": participant}
        names.setdefault((student, slug), (page.format(**fields, slug=slug), bool(form(cells["file"]))))
    return names
