"""The course in nbgrader, by its own commands, from release to feedback; what odd submissions come to."""

import csv
import html
import json
import re
import shutil
import warnings
from pathlib import Path

import pytest

from tam570_grader import cli
from tam570_grader.results.records import WHOLE
from tam570_grader.writing import assignments

TESTS = Path(__file__).parent
IN_CI = {  # assignment: the slip in what the second student hands in
    "hw07_double_pendulum": "too_few_steps",
    "hw08_axis_angle": "transposed_skew",
    "hw12_bead_on_wire": "steps_for_short_runs",
}
ONE = "hw08_axis_angle"
TELLS = 8  # characters: a detail as short as "0.0" may be on a page by chance
BY_HAND = 0.75  # of the points of a part that is graded by hand


def by_part(record):
    """part -> points of a result line."""
    parts = {}
    for mark in record["checks"]:
        parts[mark["part"]] = parts.get(mark["part"], 0) + mark["points"]
    return parts


def regraded(course, checkout, slug, out):
    """The results of `tam570-grader grade` on the collected files, with the seed that autograde took."""
    first = (course / "tam570_results" / slug / "results.jsonl").read_text().splitlines()[0]
    command = ["--root", str(checkout), "grade", str(course / "submitted"), "--only", slug, "--out", str(out)]
    assert cli.main([*command, "--seed", str(json.loads(first)["seed"])]) == 0
    return [json.loads(line) for line in (out / "results.jsonl").read_text().splitlines()]


class Term:
    """A course with two students: ann hands in the solution, ben the same with a slip."""

    def __init__(self, checkout, folder, nbgrader, made_course, slips):
        self.checkout, self.nbgrader, self.slips = checkout, nbgrader, slips
        self.course, config = made_course(folder, list(slips))
        self.homes = {name: folder / name for name in ("ann", "ben")}
        for home in self.homes.values():
            home.mkdir()
            (home / "nbgrader_config.py").write_text(config)

    def released(self):
        for slug in self.slips:
            self.nbgrader(self.course, "generate_assignment", slug)
            self.nbgrader(self.course, "release_assignment", slug)

    def handed_in(self, name, home):
        """List, fetch, work, validate (ann: what is right must pass), submit."""
        listed = self.nbgrader(home, "list")
        assert all(slug in listed for slug in self.slips)
        self.nbgrader(home, "fetch_assignment", *self.slips)
        for slug, slip in self.slips.items():
            wrong = (
                (assignments.checks_folder(self.checkout, slug) / "mistakes" / f"{slip}.py").read_text()
                if name == "ben"
                else ""
            )
            solution = (self.checkout / "solutions" / f"{slug}.py").read_text()
            (home / slug / f"{slug}.py").write_text(f"{solution}\n\n{wrong}")
            answer_in_words(home / slug / f"{slug}.ipynb")
            if name == "ann":
                assert "Success" in self.nbgrader(home / slug, "validate", f"{slug}.ipynb")
            self.nbgrader(home, "submit", slug, "--student", name)
        cached = self.nbgrader(home, "list", "--cached")
        assert all(slug in cached for slug in self.slips)

    def graded(self):
        """Collect, autograde, the parts that are graded by hand, feedback, and the table."""
        for slug in self.slips:
            self.nbgrader(self.course, "collect", slug)
            self.nbgrader(self.course, "autograde", slug)
            grade_by_hand(self.course, slug)
            self.nbgrader(self.course, "generate_feedback", slug)
            self.nbgrader(self.course, "release_feedback", slug)
        for name, home in self.homes.items():
            for slug in self.slips:
                self.nbgrader(home, "fetch_feedback", slug, "--student", name)
        self.nbgrader(self.course, "export")

    def page(self, name, slug):
        """The feedback that a student has fetched."""
        return next((self.homes[name] / slug / "feedback").rglob("*.html")).read_text()


def answer_in_words(path):
    found = json.loads(path.read_text())
    for cell in found["cells"]:
        if cell["metadata"].get("nbgrader", {}).get("solution"):
            cell["source"] = "As the momentum balance says."
    path.write_text(json.dumps(found))


def grade_by_hand(course, slug):
    """What formgrader writes when a teacher types a score: here for every manual part."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # nbgrader's own, of SQLAlchemy
        from nbgrader.api import Gradebook

        with Gradebook(f"sqlite:///{course / 'gradebook.db'}") as book:
            for submission in book.find_assignment(slug).submissions:
                for grade in (grade for one in submission.notebooks for grade in one.grades):
                    if grade.name.startswith("manual-"):
                        grade.manual_score, grade.needs_manual_grade = BY_HAND * grade.max_score, False
            book.db.commit()


@pytest.fixture
def a_whole_term(course, tmp_path, nbgrader, made_course):
    """`a_whole_term(slips)` -> the term from release to fetched feedback and exported table."""

    def a_whole_term(slips):
        term = Term(course, tmp_path, nbgrader, made_course, slips)
        term.released()
        for name, home in term.homes.items():
            term.handed_in(name, home)
        term.graded()
        return term

    return a_whole_term


def assert_the_same_scores(term, grades, out):
    """nbgrader's gradebook and its export hold the points of `tam570-grader grade`, part by part."""
    found, fractions = grades(term.course), 0
    rows = csv.DictReader((term.course / "grades.csv").read_text().splitlines())
    exported = {(row["student_id"], row["assignment"]): row for row in rows}
    for slug in term.slips:
        manual = sum(points for points, _ in assignments.assignment(term.checkout, slug).manual.values())
        for record in regraded(term.course, term.checkout, slug, out / slug):
            who, parts = (record["student"], slug), by_part(record)
            automatic = {cell: auto for (*at, cell), (auto, _) in found.items() if tuple(at) == who and auto}
            assert automatic == pytest.approx({f"part-{p}": points for p, points in parts.items() if points})
            total = record["score"] + BY_HAND * manual
            assert float(exported[who]["score"]) == pytest.approx(total, abs=1e-9)
            assert float(exported[who]["max_score"]) == pytest.approx(record["max_score"] + manual)
            fractions += sum(points % 1 != 0 for points in parts.values())
            assert (record["score"] == record["max_score"]) == (record["student"] == "ann")
    assert fractions  # scores that are no whole numbers came through, too


def assert_the_feedback_says_what_was_lost(term):
    """Every message and picture of ben's failures, nothing hidden, and none of it to ann."""
    pictures, secrets = 0, 0
    for slug in term.slips:
        pages = [html.unescape(term.page(name, slug)) for name in term.homes]
        results = (term.course / "tam570_results" / slug / "results.jsonl").read_text().splitlines()
        ben = next(r for r in map(json.loads, results) if r["student"] == "ben")
        lost = [mark for mark in ben["checks"] if mark["outcome"] == "failed"]
        assert lost, ben
        assert all(mark["message"][:40] in pages[1] for mark in lost)
        details = json.dumps([mark["failure"].get(key) for mark in lost for key in WHOLE])
        hidden = [number for number in re.findall(r"[\d.e-]+", details) if len(number) >= TELLS]
        assert not [text for text in hidden for page in pages if text in page], slug
        secrets += len(hidden)
        curves = [curve for mark in lost if (curve := mark["failure"].get("curve"))]
        drawn = [1 + bool(curve.get("keeps")) for curve in curves]
        assert pages[1].count("</svg>") - pages[0].count("</svg>") == sum(drawn)
        pictures += len(drawn)
    assert pictures and secrets


def test_three_assignments_by_nbgraders_commands(a_whole_term, nbgrader_grades, tmp_path):
    term = a_whole_term(IN_CI)
    assert_the_same_scores(term, nbgrader_grades, tmp_path / "out")
    assert_the_feedback_says_what_was_lost(term)


@pytest.mark.full
def test_all_fourteen_by_nbgraders_commands(course, a_whole_term, nbgrader_grades, tmp_path):
    slips = {
        slug: sorted((assignments.checks_folder(course, slug) / "mistakes").glob("*.py"))[0].stem
        for slug in assignments.slugs(course)
    }
    term = a_whole_term({**slips, **IN_CI})
    assert_the_same_scores(term, nbgrader_grades, tmp_path / "out")
    assert_the_feedback_says_what_was_lost(term)


def in_order(readme):
    """The commands of a README's block, without the remarks beside them."""
    lines = [line.split("#")[0].split() for line in readme.splitlines() if line.startswith("    ")]
    return [line for line in lines if line[:1] == ["nbgrader"] or line == ["jupyter", "lab"]]


def test_the_commands_of_the_courses_readme_in_their_order(course, tmp_path, nbgrader, made_course):
    made, config = made_course(tmp_path, [ONE])
    written, ours = in_order((made / "README.md").read_text()), in_order((course / "README.md").read_text())
    assert len(written) == 7 and [line[:2] for line in ours] == [line[:2] for line in written]
    for command in written:
        if command == ["jupyter", "lab"]:  # test_formgrader.py
            continue
        if command[1] == "collect":
            (tmp_path / "nbgrader_config.py").write_text(config)
            nbgrader(tmp_path, "fetch_assignment", ONE)
            shutil.copy(course / "solutions" / f"{ONE}.py", tmp_path / ONE)
            nbgrader(tmp_path, "submit", ONE, "--student", "ann")
        nbgrader(made, *command[1:])
    nbgrader(tmp_path, "fetch_feedback", ONE, "--student", "ann")
    assert "skew(v) r = v x r" in next((tmp_path / ONE / "feedback").rglob("*.html")).read_text()


# Odd submissions: one class, one autograde


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
    no_syntax: "Your file could not be read",
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


def test_the_submitted_module_is_what_stays(odd_class, course):
    made, _ = odd_class
    kept = made / "autograded" / "as_it_is" / ONE / f"{ONE}.py"
    assert kept.read_text() == (course / "solutions" / f"{ONE}.py").read_text()


@pytest.mark.parametrize(
    "odd", [changed, deleted, ungraded, renumbered, no_json, as_text], ids=lambda odd: odd.__name__
)
def test_a_locked_cell_is_as_it_was_released(odd_class, odd):
    made, _ = odd_class
    released = locked(json.loads((made / "release" / ONE / f"{ONE}.ipynb").read_text())["cells"])
    found = locked(json.loads((made / "autograded" / odd.__name__ / ONE / f"{ONE}.ipynb").read_text())["cells"])
    assert "".join(found["source"]).endswith("".join(released["source"]))
    assert found["metadata"]["nbgrader"]["points"] == 10.0


def test_a_notebook_that_does_not_parse_stays_in_submitted(odd_class):
    made, said = odd_class
    assert nb_of(made / "submitted" / "no_json" / ONE).read_text() == '{"cells": ['
    assert "could not be read" in page_of(made, "no_json") and "no_json" in said


def test_nothing_of_a_student_runs_in_the_teachers_browser(odd_class):
    made, _ = odd_class
    assert "stolen()" not in page_of(made, "forged") + page_of(made, "beside")
    assert "<b>bold</b>" not in page_of(made, "no_syntax")
    forged_page = page_of(made, "forged")
    assert "<script>sneaked" not in forged_page and "javascript:sneaked" not in forged_page
    assert "<img src=x" not in forged_page and "&lt;img src=x" in forged_page
    assert "<em>slanted</em> $a&lt;b$" in forged_page


def test_late_work_is_graded_and_known_as_late(odd_class):
    _, said = odd_class
    assert "86400" in said.replace(".0", "")


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


def test_nothing_that_was_handed_in_is_lost(odd_class):
    made, _ = odd_class
    for odd in (*FULL_MARKS, *NO_POINTS):
        came = made / "submitted" / odd.__name__ / ONE
        if odd in (linked, neighbour):
            continue
        modules = [path for path in came.glob("*.py") if path.name not in ("lab.py", f"test_{ONE}.py")]
        for module in modules:
            assert (made / "autograded" / odd.__name__ / ONE / module.name).read_bytes() == module.read_bytes()
        assert modules or odd in (no_module, folders)


def test_a_new_submission_is_graded_anew_with_the_same_inputs(odd_class, nbgrader, nbgrader_grades, course):
    made, _ = odd_class
    shutil.copy(course / "solutions" / f"{ONE}.py", made / "submitted" / "renamed" / ONE)
    nbgrader(made, "autograde", ONE, "--student", "renamed", "--force")
    assert nbgrader_grades(made)["renamed", ONE, "part-a"][0] == 10.0
    lines = (made / "tam570_results" / ONE / "results.jsonl").read_text().splitlines()
    assert len({json.loads(line)["seed"] for line in lines}) == 1
    assert len(lines) == len(FULL_MARKS) + len(NO_POINTS)


def test_a_submission_without_its_notebook_is_named_and_left(odd_class, nbgrader, nbgrader_grades):
    made, _ = odd_class
    folder = made / "submitted" / "no_notebook" / ONE
    shutil.copytree(made / "submitted" / "as_it_is" / ONE, folder)
    nb_of(folder).unlink()
    assert "no_notebook" in nbgrader(made, "autograde", ONE, "--student", "no_notebook", fails=True)
    assert (folder / f"{ONE}.py").exists() and ("no_notebook", ONE, "part-a") not in nbgrader_grades(made)


@pytest.mark.filterwarnings("ignore")  # nbgrader's own, of SQLAlchemy
def test_a_gradebook_is_set_up_once_a_command(tmp_path, monkeypatch, jupyter_environment):
    from nbgrader import api

    from tam570_grader.delivery.nbgrader_gradebook import OpenGradebook, keep_gradebooks_open

    monkeypatch.setenv("PATH", jupyter_environment["PATH"])
    made, create = [], api.create_engine
    monkeypatch.setattr(api, "create_engine", lambda *a, **k: made.append(create(*a, **k)) or made[-1])
    for command in (1, 2):
        keep_gradebooks_open()
        for name in ("ann", "ben"):
            with OpenGradebook(f"sqlite:///{tmp_path / 'gradebook.db'}", "tam570") as gradebook:
                gradebook.update_or_create_student(name)
        assert len(made) == command
    with api.Gradebook(f"sqlite:///{tmp_path / 'gradebook.db'}", "tam570") as gradebook:
        assert [student.id for student in gradebook.students] == ["ann", "ben"]
    for engine in made:
        engine.dispose()
