"""Odd submissions in nbgrader: one class, one autograde."""

import csv
import json
import shutil

import pytest

from tam570_grader.checks import assignments

pytestmark = pytest.mark.slow  # a minute of nbgrader
ONE = "hw08_axis_angle"


def nb_of(folder):
    return folder / f"{ONE}.ipynb"


def edited(folder, change):
    """Change a submitted notebook."""
    found = json.loads(nb_of(folder).read_text())
    change(found["cells"])
    nb_of(folder).write_text(json.dumps(found))


def locked(cells):
    return next(cell for cell in cells if cell["metadata"].get("nbgrader", {}).get("locked"))


def as_it_is(folder):
    pass


def noisy(folder):
    with open(folder / f"{ONE}.py", "a") as module:
        module.write("\nimport sys, warnings\nprint('!', file=sys.stderr)\nwarnings.warn('late at night')\n")


def changed(folder):
    edited(folder, lambda cells: locked(cells).update(source="10.0"))


def deleted(folder):
    edited(folder, lambda cells: cells.remove(locked(cells)))


def ungraded(folder):
    edited(folder, lambda cells: locked(cells)["metadata"]["nbgrader"].update(grade=False, schema_version=0, points=99))


def renumbered(folder):
    edited(folder, lambda cells: locked(cells)["metadata"]["nbgrader"].update(grade_id="mine"))


def strange_ids(folder):
    def name(cells):
        for number, cell in enumerate(cells):
            cell["id"] = f'"><script>stolen({number})</script>'

    edited(folder, name)


def duplicated(folder):
    """The locked cell twice more, one copy with points of its own (jupyter/nbgrader issues 108, 1083)."""

    def copy(cells):
        richer = json.loads(json.dumps(locked(cells)))
        richer["metadata"]["nbgrader"]["points"] = 99
        cells += [{**richer, "id": "copy"}, {**json.loads(json.dumps(locked(cells))), "id": "again"}]

    edited(folder, copy)


def as_text(folder):
    """The locked cell as Markdown (jupyter/nbgrader issue 92)."""

    def turn(cells):
        cell = locked(cells)
        cell.update(cell_type="markdown")
        [cell.pop(key, None) for key in ("outputs", "execution_count")]

    edited(folder, turn)


def beside(folder):
    """Files that would be run or taken for ours (jupyter/nbgrader issues 170, 258, 1211, 1842)."""
    for name in ("numpy.py", "lab.py", "sitecustomize.py", "conftest.py", "nbgrader_config.py", "tam570.py"):
        (folder / name).write_text("raise SystemExit('stolen()')\n")
    (folder / f"{ONE}.html").write_text("<script>stolen()</script>")
    (folder / "picture.svg").write_text("<svg xmlns='http://www.w3.org/2000/svg' onload='stolen()'/>")
    shutil.copy(nb_of(folder), folder / "more.ipynb")


ANSWER = """<script>sneaked()</script>

[here](javascript:sneaked()) *slanted* $a<b$

```mermaid
graph TD; A["<img src=x onerror=sneaked()>"]
```
"""


def forged(folder):
    """The stub, with outputs in the notebook that claim points, and one that a browser would run."""
    shutil.copy(folder.parents[2] / "release" / ONE / f"{ONE}.py", folder)
    points = {"output_type": "execute_result", "execution_count": 1, "metadata": {}, "data": {"text/plain": "10.0"}}
    script = {"output_type": "display_data", "metadata": {}, "data": {"text/html": "<script>stolen()</script>"}}
    png = {"output_type": "display_data", "metadata": {}, "data": {"image/png": '"><script>stolen()</script>'}}

    def forge(cells):
        answer = next(cell for cell in cells if cell["cell_type"] == "markdown")
        answer["source"] = ANSWER
        locked(cells)["outputs"] = [points]
        next(cell for cell in cells if cell["cell_type"] == "code")["outputs"] = [script, png]

    edited(folder, forge)


def no_json(folder):
    nb_of(folder).write_text('{"cells": [')


def no_module(folder):
    (folder / f"{ONE}.py").unlink()


def renamed(folder):
    (folder / f"{ONE}.py").rename(folder / "hw08.py")


def late(folder):
    (folder / "timestamp.txt").write_text("2015-02-03 00:00:00 UTC")


def no_syntax(folder):
    (folder / f"{ONE}.py").write_text("def skew(v:\n    <b>bold</b>\n")


def linked(folder):
    (folder / f"{ONE}.py").unlink()
    (folder / f"{ONE}.py").symlink_to(assignments.find() / "solutions" / f"{ONE}.py")
    (folder / "notes.html").symlink_to("../../../gradebook.db")


def folders(folder):
    """Two folders where a module should be, and a link too long to follow."""
    (folder / f"{ONE}.py").unlink()
    for name in ("hw08_a", "hw08_b"):
        (folder / name).mkdir()
    (folder / "notes").symlink_to("a" * 300)


def neighbour(folder):
    """The student's own folder is a link to somebody else's."""
    shutil.rmtree(folder.parent)
    folder.parent.symlink_to("as_it_is")


FULL_MARKS = (
    as_it_is,
    noisy,
    changed,
    deleted,
    ungraded,
    renumbered,
    no_json,
    late,
    as_text,
    beside,
    duplicated,
    strange_ids,
)
NO_POINTS = {
    forged: "skew is not written yet",
    no_module: f"There is no {ONE}.py in the folder",
    renamed: f"There is no {ONE}.py in the folder",
    no_syntax: "Your file cannot be imported: SyntaxError",
    folders: f"There is no {ONE}.py in the folder",
    linked: "is a link to a place outside of the submission",
    neighbour: "is a link to a place outside of the submission",
}


@pytest.fixture(scope="module")
def odd_class(course, tmp_path_factory, nbgrader, made_course):
    """The course after autograde and generate_feedback, and what autograde said."""
    made, _ = made_course(tmp_path_factory.mktemp("odd"), [ONE])
    nbgrader(made, "generate_assignment", ONE)
    nbgrader(made, "db", "assignment", "add", ONE, "--duedate=2015-02-02 00:00:00 UTC")
    for odd in (*FULL_MARKS, *NO_POINTS):
        folder = made / "submitted" / odd.__name__ / ONE
        shutil.copytree(made / "release" / ONE, folder)
        shutil.copy(course / "solutions" / f"{ONE}.py", folder)
        odd(folder)
    said = nbgrader(made, "autograde", ONE)
    nbgrader(made, "generate_feedback", ONE)
    return made, said


def page_of(made, student):
    return (made / "feedback" / student / ONE / f"{ONE}.html").read_text()


@pytest.mark.parametrize("odd", FULL_MARKS, ids=lambda odd: odd.__name__)
def test_what_costs_nothing(odd_class, nbgrader_grades, odd):
    made, _ = odd_class
    assert nbgrader_grades(made)[odd.__name__, ONE, "part-a"][0] == 10.0
    assert "skew(v) r = v x r" in page_of(made, odd.__name__)


@pytest.mark.parametrize("odd", NO_POINTS, ids=lambda odd: odd.__name__)
def test_what_earns_nothing_and_why(odd_class, nbgrader_grades, odd):
    made, _ = odd_class
    assert nbgrader_grades(made)[odd.__name__, ONE, "part-a"][0] == 0.0
    assert NO_POINTS[odd] in page_of(made, odd.__name__)


def test_what_a_link_leads_to_is_not_handed_out(odd_class):
    made, _ = odd_class
    assert (made / "submitted" / "linked" / ONE / "notes.html").exists()
    folders = [made / step / who / ONE for step in ("autograded", "feedback") for who in ("linked", "neighbour")]
    kept = [path for folder in folders for path in folder.iterdir()]
    assert {f"{ONE}.ipynb", f"{ONE}.html"} <= {path.name for path in kept}
    solution = (assignments.find() / "solutions" / f"{ONE}.py").read_text()
    assert all(path.name != "notes.html" and path.read_text() != solution for path in kept)


@pytest.mark.parametrize(
    "odd", [changed, deleted, ungraded, renumbered, no_json, as_text], ids=lambda odd: odd.__name__
)
def test_a_locked_cell_is_as_it_was_released(odd_class, odd):
    made, _ = odd_class
    released = locked(json.loads((made / "release" / ONE / f"{ONE}.ipynb").read_text())["cells"])
    found = locked(json.loads((made / "autograded" / odd.__name__ / ONE / f"{ONE}.ipynb").read_text())["cells"])
    assert "".join(found["source"]).endswith("".join(released["source"]))
    assert found["metadata"]["nbgrader"]["points"] == 10.0


def test_nothing_of_a_student_runs_in_the_teachers_browser(odd_class):
    made, _ = odd_class
    assert "stolen()" not in page_of(made, "forged") + page_of(made, "beside")
    assert "<b>bold</b>" not in page_of(made, "no_syntax")
    forged_page = page_of(made, "forged")
    assert "<script>sneaked" not in forged_page and "javascript:sneaked" not in forged_page
    assert "<img src=x" not in forged_page and "&lt;img src=x" in forged_page
    assert "<em>slanted</em> $a&lt;b$" in forged_page


def test_nbgraders_rule_for_late_work_is_applied(odd_class, nbgrader):
    made, _ = odd_class
    config = made / "nbgrader_config.py"
    rule, before = '\nc.LateSubmissionPlugin.penalty_method = "zero"\n', config.read_text()
    config.write_text(before + rule)
    nbgrader(made, "autograde", ONE, "--student", "late", "--force")
    nbgrader(made, "export")
    config.write_text(before)
    rows = {row["student_id"]: row for row in csv.DictReader((made / "grades.csv").read_text().splitlines())}
    assert float(rows["late"]["late_submission_penalty"]) == float(rows["late"]["raw_score"]) == 10.0
    assert float(rows["late"]["score"]) == 0.0 and float(rows["as_it_is"]["score"]) == 10.0
