"""Our grading inside nbgrader's autograde: preprocessors in place of running the notebook beside its tests."""

import contextlib
import glob
import html
import os
import re
import secrets
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import nbformat
from nbconvert.exporters import NotebookExporter
from nbgrader.api import Gradebook  # type: ignore[import-untyped]
from nbgrader.converters.base import NbGraderException  # type: ignore[import-untyped]
from nbgrader.coursedir import CourseDirectory  # type: ignore[import-untyped]
from nbgrader.preprocessors import NbGraderPreprocessor  # type: ignore[import-untyped]
from traitlets import Integer, Unicode

from tam570_grader import root
from tam570_grader.book import Book, Record
from tam570_grader.feedback import NOTES, SIGNS
from tam570_grader.notebook import FORMAT, part_of, part_points, text_cell
from tam570_grader.run import Plan, records
from tam570_grader.sandbox import Allowance
from tam570_grader.submissions import Submission, submissions

__all__ = ["ForgivingExporter", "KeepPictures", "RestoreMetadata", "SandboxGrades"]

Notebook = Any  # nbformat's own types say no more
Resources = Any
Outcome = tuple[Notebook, Resources]

COLOURS = {"passed": "#2e7d32", "failed": "#b3261e", "not_run": "#5f6368", "grader_error": "#b3261e"}
# Of a student's outputs; HTML and SVG could carry scripts to the teacher.
PICTURES = ("image/png", "image/jpeg")
BASE64 = re.compile(r"[A-Za-z0-9+/=\s]*")
BROKEN = """**This notebook could not be read** ({why}). The module beside it was graded; the file as it came is \
in `submitted/`."""
NO_MODULE = "There is no {slug}.py in the folder; the functions were looked for in {found}."


class ForgivingExporter(NotebookExporter):
    """Puts a note in the place of a notebook that cannot be read, so that the module beside it is graded."""

    def from_filename(self, filename: str, resources: Resources = None, **kwargs: Any) -> Outcome:
        why = _unreadable(filename)
        if not why:
            found: Outcome = super().from_filename(filename, resources=resources, **kwargs)
            return found
        self.log.warning("%s cannot be read (%s): its module is graded", filename, why)
        note = _node({**FORMAT, "metadata": {}, "cells": [text_cell("broken", BROKEN.format(why=why))]})
        path = Path(filename)
        resources = {**(resources or {}), "metadata": {"name": path.stem, "path": str(path.parent)}}
        made: Outcome = self.from_notebook_node(note, resources, **kwargs)  # type: ignore[no-untyped-call]
        return made


def _unreadable(filename: str) -> str:
    """Why a file is no notebook, "" if it is one."""
    try:
        cells = nbformat.read(filename, as_version=4).cells  # type: ignore[no-untyped-call]
        [(cell.cell_type, cell.source + "", cell.metadata.items()) for cell in cells]
    except Exception as error:  # nbformat raises whatever it stumbles over
        return type(error).__name__
    return ""


class RestoreMetadata(NbGraderPreprocessor):  # type: ignore[misc]
    """Makes what nbgrader notes in cells what it was when the assignment was made; strange cells are plain ones."""

    def preprocess(self, nb: Notebook, resources: Resources) -> Outcome:
        where = resources["nbgrader"]
        with Gradebook(where["db_url"]) as gradebook:
            notes = _notes_of_cells(gradebook.find_notebook(where["notebook"], where["assignment"]))
        for cell in nb.cells:
            name = _grade_id(cell)
            cell.metadata.pop("nbgrader", None)
            if name in notes:
                cell.metadata["nbgrader"] = _node(notes[name])
        return nb, resources


def _notes_of_cells(notebook: Any) -> dict[str, dict[str, Any]]:
    """What belongs into the metadata of each cell, by the gradebook."""
    points = {cell.name: cell.max_score for cell in notebook.grade_cells}
    answers = {cell.name for cell in notebook.solution_cells}
    return {
        cell.name: {
            "grade": cell.name in points, "grade_id": cell.name, "locked": cell.locked, "task": False,
            "points": points.get(cell.name, 0), "schema_version": 3, "solution": cell.name in answers,
            "cell_type": cell.cell_type, "checksum": cell.checksum,
        }
        for cell in notebook.source_cells
    }  # fmt: skip


class KeepPictures(NbGraderPreprocessor):  # type: ignore[misc]
    """Keeps a student's text and pictures, for the notebook is not run again; drops what could run in a browser."""

    def preprocess_cell(self, cell: Notebook, resources: Resources, cell_index: int) -> Outcome:
        if cell.cell_type == "code":
            locked = part_of(_grade_id(cell)) is not None
            cell.outputs = [] if locked else [safe for one in cell.outputs if (safe := _safe(one))]
        if not _pictures_only(cell.get("attachments")):
            cell.pop("attachments", None)
        return cell, resources


def _safe(output: Notebook) -> Notebook | None:
    """An output without what a browser would run; None if nothing is left."""
    kind = output.get("output_type")
    if kind == "stream":
        return _output("stream", name="stdout", text=_text(output.get("text")))
    if kind == "error":
        return _output("stream", name="stdout", text=f"{output.get('ename')}: {output.get('evalue')}")
    bundle = output.get("data")
    data = (
        {mime: text for mime, text in bundle.items() if _picture(mime, text)}
        if isinstance(bundle, dict)
        else {}
    )
    if not data and isinstance(bundle, dict) and "text/plain" in bundle:
        data = {"text/plain": _text(bundle["text/plain"])}
    return _output("display_data", data=data, metadata={}) if data else None


def _picture(mime: str, text: Any) -> bool:
    return mime in PICTURES and isinstance(text, str) and bool(BASE64.fullmatch(text))


def _pictures_only(attachments: Any) -> bool:
    return isinstance(attachments, dict) and all(
        isinstance(one, dict) and all(_picture(mime, text) for mime, text in one.items())
        for one in attachments.values()
    )


def _text(value: Any) -> str:
    return "".join(map(str, value)) if isinstance(value, list) else str(value)


class SandboxGrades(NbGraderPreprocessor):  # type: ignore[misc]
    """Grades the submitted module in the sandbox, and fills the locked cells with points and messages."""

    checkout = Unicode("", help="the checkout of tam570 with checks and solutions").tag(config=True)
    results = Unicode("tam570_results", help="the folder of the results, in the course").tag(config=True)
    jobs = Integer(0, help="workers; 0: one for each core").tag(config=True)
    memory = Integer(1024, help="MiB of a submission").tag(config=True)
    cpu = Integer(60, help="s of processor time of a submission").tag(config=True)
    call = Integer(10, help="s of processor time of one call").tag(config=True)

    def preprocess(self, nb: Notebook, resources: Resources) -> Outcome:
        slug, student = resources["nbgrader"]["assignment"], resources["nbgrader"]["student"]
        assignment = root.assignment(self._checkout(), slug)
        submission, record = self._graded(slug, student)
        if record["score"] is None:
            raise NbGraderException(
                f"the grader failed on {student} {slug}: see {self.results}/{slug}/results.jsonl"
            )
        lines = {check.name: check.line for check in assignment.checks}
        for cell in nb.cells:
            part = part_of(_grade_id(cell))
            if part in part_points(assignment):
                marks = [mark for mark in record["checks"] if mark["part"] == part]
                cell.outputs = _outputs(marks, lines, _notes(submission, record))
        return nb, resources

    def _checkout(self) -> Path:
        return root.find(self.checkout or None)

    def _graded(self, slug: str, student: str) -> tuple[Submission, Record]:
        """A submission and its result; with the first that is new, all that are new are graded, on warm workers."""
        place = CourseDirectory(parent=self)
        mine = _submission(place, slug, student)
        folders = sorted(glob.glob(place.format_path(place.submitted_directory, place.student_id, slug)))
        everyone = submissions([Path(folder) for folder in folders], root.slugs(self._checkout()), slug)
        others = [one for one in everyone if one.student != mine.student]
        with contextlib.closing(Book(Path(place.root) / self.results / slug)) as book:
            return mine, _result(self._plan(place, book, [mine, *others]), book, mine)

    def _plan(self, place: Any, book: Book, everyone: Sequence[Submission]) -> Plan:
        seed = secrets.randbelow(2**31) if book.seed is None else book.seed
        allowance = Allowance(self.memory * 2**20, self.cpu, self.call)
        jobs = self.jobs or os.cpu_count() or 1
        hidden = [self._checkout(), Path(place.root).resolve()]
        return Plan(self._checkout(), everyone, seed, jobs, allowance, hidden)


def _submission(place: Any, slug: str, student: str) -> Submission:
    folder = Path(place.format_path(place.submitted_directory, student, slug))
    return submissions([folder], [slug], slug)[0]


def _result(plan: Plan, book: Book, mine: Submission) -> Record:
    """The result of the plan's first submission; if it is in the book, nobody else is looked at."""
    known = {record["digest"] for record in book.records()}
    stream = records(plan, book)
    first = next(stream)
    if first["digest"] in known and first["student"] == mine.student:
        return first
    return next(record for record in [first, *stream] if record["student"] == mine.student)


def _notes(submission: Submission, record: Record) -> str:
    """What is to say of the submission as a whole."""
    slug, path = submission.slug, submission.path
    elsewhere = path is not None and path.name != f"{slug}.py"
    found = NO_MODULE.format(slug=slug, found=path.name) if elsewhere and path else ""
    return " ".join(filter(None, (found, NOTES.get(record["status"]), record.get("message"))))


def _outputs(marks: Sequence[Mapping[str, Any]], lines: Mapping[str, str], note: str) -> list[Notebook]:
    """The messages of a part, and its points as nbgrader reads them: the number that a cell ends with."""
    earned = round(sum(mark["points"] for mark in marks), 6)
    rows = "".join(_row(mark, lines.get(mark["name"], mark["name"])) for mark in marks)
    page = f"{f'<p><b>{html.escape(note)}</b></p>' if note else ''}<table>{rows}</table>"
    plain = "\n".join([*([note] if note else []), *(_plain(mark, lines) for mark in marks)])
    messages = _output("display_data", data={"text/html": page, "text/plain": plain}, metadata={})
    return [
        messages,
        _output("execute_result", data={"text/plain": repr(earned)}, metadata={}, execution_count=1),
    ]


def _row(mark: Mapping[str, Any], line: str) -> str:
    colour, says = COLOURS[mark["outcome"]], mark["outcome"].replace("_", " ")
    message = "" if mark["outcome"] == "passed" else f"<br>{says}: {html.escape(mark['message'])}"
    points = f"{mark['points']:g} / {mark['max_points']:g}"
    return (
        f'<tr><td style="color:{colour};white-space:nowrap;padding-right:1em">{points}</td>'
        f'<td style="text-align:left">{html.escape(line)}{message}</td></tr>'
    )


def _plain(mark: Mapping[str, Any], lines: Mapping[str, str]) -> str:
    return f"{SIGNS[mark['outcome']]} {mark['points']:g}/{mark['max_points']:g} {lines.get(mark['name'], mark['name'])}"


def _output(kind: str, **content: Any) -> Notebook:
    return _node({"output_type": kind, **content})


def _node(content: Mapping[str, Any]) -> Notebook:
    return nbformat.from_dict(content)  # type: ignore[no-untyped-call]


def _grade_id(cell: Notebook) -> str:
    """The name by which nbgrader knows a cell, "" if it does not."""
    noted = cell.metadata.get("nbgrader")
    name = noted.get("grade_id") if isinstance(noted, dict) else None
    return name if isinstance(name, str) else ""
