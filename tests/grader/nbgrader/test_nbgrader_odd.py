"""Odd submissions in nbgrader, graded by one run of autograde."""

import copy
import json
import shutil

import pytest
from classes import HW08 as ONE
from classes import rows

from tam570_grader.checks import assignments

pytestmark = pytest.mark.slow  # a minute of nbgrader
SOLUTION = assignments.find() / "solutions" / f"{ONE}.py"
ANSWER = """<script>sneaked()</script>

[here](javascript:sneaked()) *slanted* $a<b$

```mermaid
graph TD; A["<img src=x onerror=sneaked()>"]
```
"""


def locked(cells):
    return next(cell for cell in cells if cell["metadata"].get("nbgrader", {}).get("locked"))


def edited(change):
    """Return a function that applies `change` to the cells of the notebook in a folder."""

    def edit(folder):
        path = folder / f"{ONE}.ipynb"
        notebook = json.loads(path.read_text())
        change(notebook["cells"])
        path.write_text(json.dumps(notebook))

    return edit


def strange_ids(cells):
    for number, cell in enumerate(cells):
        cell["id"] = f'"><script>stolen({number})</script>'


def duplicated(cells):
    """Add two copies of the locked cell, one of them with other points (jupyter/nbgrader issues 108, 1083)."""
    richer, copied = ({**copy.deepcopy(locked(cells)), "id": name} for name in ("richer", "again"))
    richer["metadata"]["nbgrader"]["points"] = 99
    cells += [richer, copied]


def as_text(cells):
    """Turn the locked cell into Markdown (jupyter/nbgrader issue 92)."""
    cell = locked(cells)
    cell.update(cell_type="markdown")
    [cell.pop(key, None) for key in ("outputs", "execution_count")]


def noisy(folder):
    with open(folder / f"{ONE}.py", "a") as module:
        module.write("\nimport sys, warnings\nprint('!', file=sys.stderr)\nwarnings.warn('late at night')\n")


def beside(folder):
    """Add files that tools would run or that imitate the grader's (jupyter/nbgrader issues 170, 258, 1211, 1842)."""
    for name in ("numpy.py", "lab.py", "sitecustomize.py", "conftest.py", "nbgrader_config.py", "tam570.py"):
        (folder / name).write_text("raise SystemExit('stolen()')\n")
    (folder / f"{ONE}.html").write_text("<script>stolen()</script>")
    (folder / "picture.svg").write_text("<svg xmlns='http://www.w3.org/2000/svg' onload='stolen()'/>")
    shutil.copy(folder / f"{ONE}.ipynb", folder / "more.ipynb")


def forged(folder):
    """Hand in the stub, with outputs in the notebook that claim points or that a browser would run."""
    shutil.copy(folder.parents[2] / "release" / ONE / f"{ONE}.py", folder)
    points = {"output_type": "execute_result", "execution_count": 1, "metadata": {}, "data": {"text/plain": "10.0"}}
    script = {"output_type": "display_data", "metadata": {}, "data": {"text/html": "<script>stolen()</script>"}}
    png = {"output_type": "display_data", "metadata": {}, "data": {"image/png": '"><script>stolen()</script>'}}

    def forge(cells):
        next(cell for cell in cells if cell["cell_type"] == "markdown")["source"] = ANSWER
        locked(cells)["outputs"] = [points]
        next(cell for cell in cells if cell["cell_type"] == "code")["outputs"] = [script, png]

    edited(forge)(folder)


def linked(folder):
    (folder / f"{ONE}.py").unlink()
    (folder / f"{ONE}.py").symlink_to(SOLUTION)
    (folder / "notes.html").symlink_to("../../../gradebook.db")


def folders(folder):
    """Replace the module by two folders, and add a link whose target is too long."""
    (folder / f"{ONE}.py").unlink()
    for name in ("hw08_a", "hw08_b"):
        (folder / name).mkdir()
    (folder / "notes").symlink_to("a" * 300)


def neighbour(folder):
    """Replace the student's folder by a link to another student's."""
    shutil.rmtree(folder.parent)
    folder.parent.symlink_to("as_it_is")


UNGRADED = {"grade": False, "schema_version": 0, "points": 99}
LOCKED = {  # student: how the locked cell is changed
    "changed": edited(lambda cells: locked(cells).update(source="10.0")),
    "deleted": edited(lambda cells: cells.remove(locked(cells))),
    "ungraded": edited(lambda cells: locked(cells)["metadata"]["nbgrader"].update(UNGRADED)),
    "renumbered": edited(lambda cells: locked(cells)["metadata"]["nbgrader"].update(grade_id="mine")),
    "as_text": edited(as_text),
    "no_json": lambda folder: (folder / f"{ONE}.ipynb").write_text('{"cells": ['),
}
FULL_MARKS = LOCKED | {
    "as_it_is": lambda folder: None,
    "noisy": noisy,
    "late": lambda folder: (folder / "timestamp.txt").write_text("2015-02-03 00:00:00 UTC"),
    "beside": beside,
    "duplicated": edited(duplicated),
    "strange_ids": edited(strange_ids),
    "renamed": lambda folder: (folder / f"{ONE}.py").rename(folder / "hw08.py"),
}
THERE_IS_NONE = f"No {ONE}.py with functions is in the folder"
LEADS_AWAY = "is a link to a place outside of the submission"
NO_POINTS = {
    "forged": (forged, "skew is not written yet"),
    "no_module": (lambda folder: (folder / f"{ONE}.py").unlink(), THERE_IS_NONE),
    "no_syntax": (lambda folder: (folder / f"{ONE}.py").write_text("def skew(v:\n    <b>bold</b>\n"), "SyntaxError"),
    "folders": (folders, THERE_IS_NONE),
    "linked": (linked, LEADS_AWAY),
    "neighbour": (neighbour, LEADS_AWAY),
}


@pytest.fixture(scope="module")
def built(course, tmp_path_factory, nbgrader, made_course):
    """Return the folder of the course after autograde and generate_feedback."""
    built, _ = made_course(tmp_path_factory.mktemp("odd"), [ONE])
    nbgrader(built, "generate_assignment", ONE)
    nbgrader(built, "db", "assignment", "add", ONE, "--duedate=2015-02-02 00:00:00 UTC")
    for name, change in (FULL_MARKS | {name: change for name, (change, _) in NO_POINTS.items()}).items():
        folder = built / "submitted" / name / ONE
        shutil.copytree(built / "release" / ONE, folder)
        shutil.copy(SOLUTION, folder)
        change(folder)
    assert "no_json" in nbgrader(built, "autograde", ONE)
    nbgrader(built, "generate_feedback", ONE)
    return built


def page_of(built, student):
    return (built / "feedback" / student / ONE / f"{ONE}.html").read_text()


@pytest.mark.parametrize("student", FULL_MARKS)
def test_what_costs_nothing(built, nbgrader_grades, student):
    assert nbgrader_grades(built)[student, ONE, "part-a"][0] == 10.0
    assert "skew(v) r = v x r" in page_of(built, student)


@pytest.mark.parametrize("student", NO_POINTS)
def test_what_earns_nothing_and_why(built, nbgrader_grades, student):
    assert nbgrader_grades(built)[student, ONE, "part-a"][0] == 0.0
    assert NO_POINTS[student][1] in page_of(built, student)


@pytest.mark.parametrize("student", LOCKED)
def test_a_locked_cell_is_as_it_was_released(built, student):
    books = [built / path / ONE / f"{ONE}.ipynb" for path in ("release", f"autograded/{student}")]
    released, stored = (locked(json.loads(book.read_text())["cells"]) for book in books)
    assert "".join(stored["source"]).endswith("".join(released["source"]))
    assert stored["metadata"]["nbgrader"]["points"] == 10.0


def test_what_a_link_leads_to_is_not_handed_out(built):
    assert (built / "submitted" / "linked" / ONE / "notes.html").exists()
    places = [built / step / who / ONE for step in ("autograded", "feedback") for who in ("linked", "neighbour")]
    stored = [path for folder in places for path in folder.iterdir()]
    assert {f"{ONE}.ipynb", f"{ONE}.html"} <= {path.name for path in stored}
    assert all(path.name != "notes.html" and path.read_text() != SOLUTION.read_text() for path in stored)


def test_nothing_of_a_student_runs_in_the_teachers_browser(built):
    page = page_of(built, "forged")
    assert "stolen()" not in page + page_of(built, "beside") and "<b>bold</b>" not in page_of(built, "no_syntax")
    assert "<script>sneaked" not in page and "javascript:sneaked" not in page
    assert "<img src=x" not in page and "&lt;img src=x" in page and "<em>slanted</em> $a&lt;b$" in page


def test_nbgraders_rule_for_late_work_is_applied(built, nbgrader):
    config = built / "nbgrader_config.py"
    before = config.read_text()
    config.write_text(f'{before}\nc.LateSubmissionPlugin.penalty_method = "zero"\n')
    nbgrader(built, "autograde", ONE, "--student", "late", "--force")
    nbgrader(built, "export")
    config.write_text(before)
    table = {row["student_id"]: row for row in rows(built / "grades.csv")}
    assert float(table["late"]["late_submission_penalty"]) == float(table["late"]["raw_score"]) == 10.0
    assert float(table["late"]["score"]) == 0.0 and float(table["as_it_is"]["score"]) == 10.0
