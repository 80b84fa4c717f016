"""Grade inside nbgrader's autograde: an exporter and preprocessors that replace the execution of notebooks."""

import contextlib
import fnmatch
import functools
import glob
import os
import re
import stat
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import nbformat
from jinja2 import pass_context
from nbconvert.exporters import NotebookExporter
from nbconvert.filters.markdown_mistune import IPythonRenderer, MarkdownWithMath
from nbgrader.converters import base  # type: ignore[import-untyped]
from nbgrader.converters.base import NbGraderException  # type: ignore[import-untyped]
from nbgrader.preprocessors import NbGraderPreprocessor  # type: ignore[import-untyped]
from nbgrader.utils import find_all_files  # type: ignore[import-untyped]
from traitlets import Bool, Dict, Integer, Unicode

from tam570.notebooks import LARGEST, LARGEST_WITH_OUTPUTS
from tam570.values import Json
from tam570_grader.checks import assignments
from tam570_grader.course import course_config
from tam570_grader.grading.batch import RunConfig, records
from tam570_grader.grading.executor import cores
from tam570_grader.grading.seeds import seed as seed_of
from tam570_grader.grading.submissions import MOST_FILES, BadPath, CannotRead, Submission, of_folder, read, submissions
from tam570_grader.nbgrader.cells import Notebook, grade_id, marked, node, pictures_only, rebuilt, remark, safe
from tam570_grader.nbgrader.gradebook import OpenGradebook, keep_gradebooks_open
from tam570_grader.release.notebook import FORMAT, noted, part_of, part_points, text_cell
from tam570_grader.reports.feedback import load_assignment_info
from tam570_grader.results.records import read as as_result
from tam570_grader.results.store import Record, ResultStore
from tam570_grader.sandbox.notebooks import Unshown, cells_of

Resources = Any
Outcome = tuple[Notebook, Resources]

BROKEN = """**This notebook could not be read** ({why}). The module beside it was graded; the file as it came is \
in `submitted/`."""


class ForgivingExporter(NotebookExporter):
    """Exporter that replaces an unreadable notebook by a note, so that the module beside it is graded.

    Each command has one instance, which locks the results of its assignments and caches those of the class.
    """

    optimistic_validation = Bool(True, help="look at the notebook once, after the last preprocessor").tag(config=True)
    results = Dict(help="(assignment, student) -> submission and result")
    stores = Dict(help="assignment -> its results, which no other command writes before this one ends")

    def __init__(self, **kwargs: Any) -> None:
        super().__init__(**kwargs)  # type: ignore[no-untyped-call]
        keep_gradebooks_open()
        self.parent.convert_notebooks = functools.partial(self._alone, self.parent.convert_notebooks)  # type: ignore[union-attr]

    def _alone(self, convert: Callable[[], None]) -> None:
        """Convert while the results are locked: nbgrader deletes the folder of each student for whom grading fails."""
        coursedir, grades = self.parent.coursedir, SandboxGrades(parent=self)  # type: ignore[union-attr]
        slugs = fnmatch.filter(assignments.slugs(grades.found_checkout()), coursedir.assignment_id)
        with contextlib.ExitStack() as still:
            for slug in slugs:
                store = ResultStore(Path(coursedir.root) / grades.results / slug, self.log.warning)
                self.stores[slug] = still.enter_context(contextlib.closing(store))
            still.enter_context(_copying(functools.partial(_own_files, self._submitted())))
            convert()

    def _submitted(self) -> str:
        """Return a glob pattern of the submissions' folders."""
        coursedir: Any = self.parent.coursedir  # type: ignore[union-attr]
        return str(coursedir.format_path(coursedir.submitted_directory, "*", "*"))

    def from_filename(self, filename: str, resources: Resources = None, **kwargs: Any) -> Outcome:
        path = Path(filename)
        is_submitted = fnmatch.fnmatch(str(path.parent), self._submitted())
        notebook = _students(path) if is_submitted else _notebook(filename)
        if isinstance(notebook, str):
            self.log.warning("%s cannot be read (%s): its module is graded", filename, notebook)
            cells = [text_cell("broken", BROKEN.format(why=notebook))]
            notebook = node({**FORMAT, "metadata": {}, "cells": cells})
        resources = {**(resources or {}), "metadata": {"name": path.stem, "path": str(path.parent)}}
        outcome: Outcome = self.from_notebook_node(notebook, resources, **kwargs)  # type: ignore[no-untyped-call]
        return outcome


def _students(path: Path) -> Notebook | str:
    """Return a student's notebook, parsed in the sandbox, or the reason why it cannot be read."""
    if path.is_symlink() or _linked(path.parent):
        return "it is a link"
    try:
        source = read(Submission("", "", path, path.parent))
        return rebuilt(cells_of(source.text))
    except (CannotRead, Unshown) as reason:
        return str(reason)


def _notebook(filename: str) -> Notebook | str:
    """Return one of the instructor's notebooks, or the name of the exception that reading it raises."""
    try:
        return nbformat.read(filename, as_version=4)  # type: ignore[no-untyped-call]
    except Exception as error:  # nbformat raises many types
        return type(error).__name__


class RestoreMetadata(NbGraderPreprocessor):  # type: ignore[misc]
    """Preprocessor that restores nbgrader's metadata from the gradebook; cells that are not in it become plain."""

    def preprocess(self, nb: Notebook, resources: Resources) -> Outcome:
        where = resources["nbgrader"]
        with OpenGradebook(where["db_url"]) as gradebook:
            notes = _notes_of_cells(gradebook.find_notebook(where["notebook"], where["assignment"]))
        for cell in nb.cells:
            name = grade_id(cell)
            cell.metadata.pop("nbgrader", None)
            if name in notes:
                cell.metadata["nbgrader"] = node(notes.pop(name))  # popped: a copy of the cell becomes a plain cell
        return nb, resources


def _notes_of_cells(notebook: Any) -> dict[str, Json]:
    """Return nbgrader's metadata of each cell by grade id, from the gradebook."""
    points = {cell.name: cell.max_score for cell in notebook.grade_cells}
    answers = {cell.name for cell in notebook.solution_cells}
    return {
        cell.name: {
            **noted(cell.name, points.get(cell.name), locked=cell.locked, solution=cell.name in answers),
            "cell_type": cell.cell_type,
            "checksum": cell.checksum,
        }
        for cell in notebook.source_cells
    }


class _PlainRenderer(IPythonRenderer):
    """nbconvert's renderer, except that it escapes Mermaid diagrams and shows them as code."""

    def block_mermaidjs(self, code: str) -> str:
        return self.block_code(code)


@pass_context
def markdown_without_html(context: Any, source: str) -> str:
    """Return Markdown rendered as by nbconvert, but with HTML escaped and without links that run code."""
    pictures = context.get("cell", {}).get("attachments", {})
    renderer = _PlainRenderer(escape=True, allow_harmful_protocols=False, attachments=pictures)
    return str(MarkdownWithMath(renderer=renderer).render(source))


class KeepPictures(NbGraderPreprocessor):  # type: ignore[misc]
    """Preprocessor that keeps text and pictures of cells, as none is executed, and drops what a browser would run."""

    def preprocess_cell(self, cell: Notebook, resources: Resources, cell_index: int) -> Outcome:
        if cell.cell_type == "code":
            locked = part_of(grade_id(cell)) is not None
            cell.outputs = [] if locked else [safe_output for output in cell.outputs if (safe_output := safe(output))]
        if not pictures_only(cell.get("attachments")):
            cell.pop("attachments", None)
        return cell, resources


class SandboxGrades(NbGraderPreprocessor):  # type: ignore[misc]
    """Preprocessor that grades the submitted module in the sandbox, and fills the locked cells with the results."""

    checkout = Unicode("", help="the checkout of tam570 with checks and solutions").tag(config=True)
    results = Unicode("tam570_results", help="the folder of the results, in the course").tag(config=True)
    jobs = Integer(0, help="workers; 0: one for each core").tag(config=True)
    memory = Integer(0, help="MiB of a submission; 0: as in course.toml, else 1024").tag(config=True)
    cpu = Integer(0, help="s of processor time of a submission; 0: as in course.toml, else 60").tag(config=True)
    call = Integer(0, help="s of processor time of one call; 0: as in course.toml, else 10").tag(config=True)

    def preprocess(self, nb: Notebook, resources: Resources) -> Outcome:
        slug, student = resources["nbgrader"]["assignment"], resources["nbgrader"]["student"]
        submission, record = self._graded(slug, student)
        if record["score"] is None:
            raise NbGraderException(f"the grader failed on {student} {slug}: see {self.results}/{slug}/results.jsonl")
        checkout = self.found_checkout()
        info, graded = load_assignment_info(checkout, slug), part_points(assignments.assignment(checkout, slug))
        result = as_result(record)
        for cell in nb.cells:
            part = part_of(grade_id(cell))
            if part in graded:
                cell.outputs = marked(result, part, info, remark(submission, result))
        return nb, resources

    def found_checkout(self) -> Path:
        return course_config.course_of(self.checkout or None, is_told=False)

    def _graded(self, slug: str, student: str) -> tuple[Submission, Record]:
        """Return a submission and its record; the first call grades all submissions of the command."""
        graded: dict[tuple[str, str], tuple[Submission, Record]] = self.parent.results
        if (slug, student) not in graded:
            coursedir = self.parent.parent.coursedir
            everyone = _class(coursedir, slug)
            store: ResultStore = self.parent.stores[slug]
            checkout, seed = self.found_checkout(), seed_of(None, [store], None)
            limits = course_config.resource_limits(checkout, memory=self.memory, cpu=self.cpu, call=self.call)
            hidden = [checkout, Path(coursedir.root).resolve()]
            config = RunConfig(checkout, everyone, seed, self.jobs or cores(), limits, hidden)
            by_student = {record["student"]: record for record in records(config, store)}
            graded.update({(slug, record.student): (record, by_student[record.student]) for record in everyone})
        return graded[slug, student]


def _class(coursedir: Any, slug: str) -> list[Submission]:
    """Return the submissions of the command: all students', or those that match its student id."""
    student = re.compile(coursedir.format_path(coursedir.submitted_directory, "(?P<who>.*)", slug, escape=True))
    folders = sorted(glob.glob(coursedir.format_path(coursedir.submitted_directory, coursedir.student_id, slug)))
    everyone = []
    for who, folder in [(match["who"], Path(folder)) for folder in folders if (match := student.fullmatch(folder))]:
        if _linked(folder):
            message = "the folder is a link to a place outside of the submission"
            everyone.append(Submission(who, slug, None, folder, message))
            continue
        try:
            everyone.append(replace(submissions([folder], [slug], slug)[0], student=who))
        except BadPath:  # for example, it contains several folders
            everyone.append(of_folder(folder, who, slug, folder))
    return everyone


@contextlib.contextmanager
def _copying(find: Callable[..., list[str]]) -> Iterator[None]:
    """Let nbgrader copy only the files that `find` returns; undone at the end, for a server's other commands."""
    earlier, base.find_all_files = base.find_all_files, find
    try:
        yield
    finally:
        base.find_all_files = earlier


def _own_files(submitted: str, folder: str, exclude: Any = None) -> list[str]:
    """Return the files in a folder; in a submission only small regular ones, as a link could expose other files."""
    files: list[str] = find_all_files(folder, exclude)
    if not fnmatch.fnmatch(folder, submitted):
        return files
    return [] if _linked(Path(folder)) else [file for file in files if _is_small(file)][:MOST_FILES]


def _is_small(file: str) -> bool:
    """Return whether a file is regular and no larger than a submission may be."""
    status = os.lstat(file)
    most = LARGEST_WITH_OUTPUTS if file.endswith(".ipynb") else LARGEST
    return stat.S_ISREG(status.st_mode) and status.st_size <= most


def _linked(folder: Path) -> bool:
    """Return whether a folder of a student's assignment, or its parent, the student's folder, is a link."""
    return folder.is_symlink() or folder.parent.is_symlink()
