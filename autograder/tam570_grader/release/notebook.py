"""Generate an assignment's notebook: the problem part by part, cells that show the student's module, graded cells."""

import json
import re
import shutil
from collections.abc import Iterable
from pathlib import Path

from tam570 import handin
from tam570.checking.changes import calls
from tam570.values import Json
from tam570_grader.checks import assignments
from tam570_grader.checks.assignments import LoadedAssignment
from tam570_grader.checks.rubric import rubric_table, without_rubric
from tam570_grader.results.tables import written

TEMPLATES = Path(__file__).parent / "templates"
CellRecord = Json

PART = re.compile(r"^\*\*\(([a-z])\)\*\*", re.MULTILINE)
FENCE = re.compile(r"^## ([a-z])\n+```python\n(.*?)^```$", re.MULTILINE | re.DOTALL)
LOCKED = "part-"  # prefix of a locked cell's id, before the letter of its part
FORMAT = {"nbformat": 4, "nbformat_minor": 5}
KERNEL = {"kernelspec": {"display_name": "Python 3 (ipykernel)", "language": "python", "name": "python3"}}

HOW = """---
Fill in the functions of `{slug}.py` beside this notebook, in any editor. The notebook reads the file again whenever
you save it; run a cell again to see what has become of it. The cells that run tests are locked; add cells where
you like, and write where it says *your answer*. {hand_in}
Where your course has a Submit button, it hands in the same files."""
SETUP = """%load_ext autoreload
%autoreload 2
%matplotlib inline

import matplotlib.pyplot as plt
import numpy as np

import lab
import {slug} as hw
from tam570.show import show"""
SCENE = "**What it looks like**, by your functions. Run the cell again when you have changed them."
TESTS = "# Part ({part}): your visible tests. This cell is locked; it carries the points of the hidden ones.\n{call}"
BY_HAND = "**By hand ({part}), {worth}:** {what}. Put plots into cells of their own above; words here.\n\n{claims}"
BEFORE = "**Before you look ({part}):** {before}"


def problem(readme: str) -> tuple[str, dict[str, str], str]:
    """Split a README into the text before the lettered parts, the parts by letter, and the table and all after it."""
    text, bar, table = readme.partition("\n|")
    starts = list(PART.finditer(text))
    ends = [start.start() for start in starts[1:]] + [len(text)] if starts else []
    parts = {start[1]: text[start.start() : end].strip() for start, end in zip(starts, ends, strict=True)}
    return text[: starts[0].start() if starts else None].strip(), parts, (bar + table).strip()


def notebook(assignment: LoadedAssignment, readme: str, tests: str, pictures: str) -> Json:
    """Return the notebook in nbformat's JSON.

    readme, tests : the assignment's files for students
    pictures      : Markdown with a code block under the letter of each part that shows something
    """
    intro, parts, rest = problem(without_rubric(readme))
    first = {"cell_type": "markdown", "id": "problem", "metadata": {}}
    how = HOW.format(slug=assignment.slug, hand_in=handin.HOW.format(name=assignment.slug[:4]))
    cells: list[CellRecord] = [
        {**first, "source": f"{intro}\n\n{how}"},
        _code("setup", SETUP.format(slug=assignment.slug)),
    ]
    shown, tested = dict(FENCE.findall(pictures)), visible_by_part(assignment, tests)
    for part in sorted({*parts, *part_points(assignment), *assignment.rubric}):
        text = parts.get(part, f"**({part})**")
        cells += _part(assignment, part, text, shown.get(part), tested.get(part, []))
    cells += [text_cell("look", SCENE), _code("scene", "show(hw)"), text_cell("graded", rest)]
    return {**FORMAT, "metadata": KERNEL, "cells": cells}


def write_notebook(course: Path, slug: str, folder: Path) -> None:
    """Write an assignment's notebook, and `lab.py`, which it imports."""
    released = course / "assignments" / slug
    shutil.copyfile(TEMPLATES / "lab.py", folder / "lab.py")
    pictures = assignments.checks_folder(course, slug) / "notebook.md"
    content = notebook(
        assignments.assignment(course, slug),
        (released / "README.md").read_text(encoding="utf-8"),
        (released / f"test_{slug}.py").read_text(encoding="utf-8"),
        pictures.read_text(encoding="utf-8") if pictures.exists() else "",
    )
    written(folder / f"{slug}.ipynb", json.dumps(content, indent=1, ensure_ascii=False) + "\n")


def part_points(assignment: LoadedAssignment) -> dict[str, float]:
    """Return the points that the checks give for each part."""
    parts = sorted({check.part for check in assignment.checks})
    return {p: round(sum(check.points for check in assignment.checks if check.part == p), 6) for p in parts}


def part_of(grade_id: str) -> str | None:
    """Return the part for whose checks a locked cell gives points, None for any other cell."""
    return grade_id.removeprefix(LOCKED) if grade_id.startswith(LOCKED) else None


def functions_by_part(assignment: LoadedAssignment) -> dict[str, str]:
    """Return the part of each function: that of its first check, else the first part."""
    parts: dict[str, str] = {}
    for check in assignment.checks:
        parts.setdefault(check.function, check.part)
    first = assignment.checks[0].part
    return {name: parts.get(name, first) for name in assignment.returns}


def visible_by_part(assignment: LoadedAssignment, tests: str) -> dict[str, list[str]]:
    """Return the names of the visible tests of each part; a test belongs to the last part whose functions it uses."""
    parts, graded = functions_by_part(assignment), sorted(part_points(assignment))
    functions: dict[str, list[str]] = {part: [] for part in graded}
    for name, used in calls(tests, assignment.slug).items():
        functions[max((parts[function] for function in used & parts.keys()), default=graded[0])].append(name)
    return functions


def _part(
    assignment: LoadedAssignment, part: str, text: str, shown: str | None, tests: Iterable[str]
) -> list[CellRecord]:
    cells = [text_cell(f"text-{part}", text)]
    manual = assignment.rubric.get(part)
    if manual and manual.before:
        cells.append(text_cell(f"before-{part}", BEFORE.format(part=part, before=manual.before)))
        cells.append(text_cell(f"guess-{part}", "*Your prediction*"))
    if shown:
        cells.append(_code(f"picture-{part}", shown.rstrip()))
    if manual:
        task = BY_HAND.format(part=part, worth=manual.worth, what=manual.asks, claims=rubric_table(manual))
        answer = text_cell(f"manual-{part}", manual.prompt)
        answer["metadata"] = {"nbgrader": noted(f"manual-{part}", manual.points, locked=False, solution=True)}
        cells += [text_cell(f"task-{part}", task), _code(f"work-{part}", "# your plots and numbers\n"), answer]
    if part in part_points(assignment):
        cells.append(_locked(assignment, part, tests))
    return cells


def _locked(assignment: LoadedAssignment, part: str, tests: Iterable[str]) -> CellRecord:
    """Return the locked cell that runs the visible tests of a part and has the points of its checks."""
    points = part_points(assignment)[part]
    names = "".join(f"    {json.dumps(name)},\n" for name in tests)
    used = sorted({check.function for check in assignment.checks if check.part == part})
    functions = "" if names else f"    functions={json.dumps(used)},\n"
    call = f"lab.tests(\n{names}{functions}    points={points!r},\n)"
    cell = _code(f"{LOCKED}{part}", TESTS.format(part=part, call=call))
    cell["metadata"] = {"nbgrader": noted(f"{LOCKED}{part}", points, locked=True, solution=False)}
    return cell


def noted(grade_id: str, points: float | None, *, locked: bool, solution: bool) -> Json:
    """Return nbgrader's metadata of a cell; with None as `points` it is not graded."""
    worth = 0 if points is None else points
    graded = {"grade": points is not None, "grade_id": grade_id, "locked": locked, "points": worth}
    return {**graded, "schema_version": 3, "solution": solution, "task": False}


def text_cell(name: str, source: str) -> CellRecord:
    """Return a plain Markdown cell."""
    return {"cell_type": "markdown", "id": name, "metadata": {}, "source": source}


def _code(name: str, source: str) -> CellRecord:
    return {"cell_type": "code", "id": name, "metadata": {}, "source": source, "outputs": [], "execution_count": None}
