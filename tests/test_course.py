"""The course in nbgrader, by its own commands, from release to feedback; what odd submissions come to."""

import csv
import json
import os
import shutil
import subprocess
import sys
import warnings
from pathlib import Path

import pytest

from tam570_grader import cli, root
from tam570_grader.course import TEMPLATES
from tam570_grader.notebook import functions_by_part, notebook, part_points, problem, visible_by_part
from tam570_grader.stubs import stub

TESTS = Path(__file__).parent
PICTURES = TEMPLATES / "pictures"
IN_CI = {  # assignment: the slip in what the second student hands in
    "hw07_double_pendulum": "too_few_steps",
    "hw08_axis_angle": "skew_transposed",
    "hw12_bead_on_wire": "steps_for_short_runs",
}
ONE = "hw08_axis_angle"
SERVER = """
import json, os, sys, warnings
from nbgrader.apps import NbGraderApp
for line in sys.stdin:
    where, log, *command = json.loads(line)
    child = os.fork()
    if child == 0:
        os.chdir(where)
        os.environ["HOME"] = os.environ["JUPYTER_DATA_DIR"] = where
        for stream in (1, 2):
            os.dup2(os.open(log, os.O_WRONLY | os.O_CREAT | os.O_APPEND), stream)
        NbGraderApp.launch_instance(command)
        sys.stdout.flush()
        os._exit(0)
    print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), flush=True)
"""


@pytest.fixture(scope="module")
def nbgrader(tmp_path_factory):
    """`nbgrader(folder, *command)` -> what it says; the command line in a process that has imported it already."""
    log = tmp_path_factory.mktemp("log") / "log.txt"
    path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"  # nbgrader starts alembic and jupyter
    server = subprocess.Popen(
        [sys.executable, "-c", SERVER], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
        env={**os.environ, "PATH": path},
    )  # fmt: skip

    def nbgrader(folder, *command, fails=False):
        log.write_text("")
        server.stdin.write(json.dumps([str(folder), str(log), *command]) + "\n")
        server.stdin.flush()
        code = int(server.stdout.readline())
        assert (code != 0) == fails, log.read_text()
        return log.read_text()

    yield nbgrader
    server.stdin.close()
    server.wait()
    server.stdout.close()


def made_course(course, folder, slugs):
    """The course as the command writes it, with an exchange beside it."""
    assert cli.main(["--root", str(course), "course", str(folder / "course"), *slugs]) == 0
    (folder / "exchange").mkdir(mode=0o777, exist_ok=True)
    setting = f'\nc.Exchange.root = "{folder / "exchange"}"\n'
    with open(folder / "course" / "nbgrader_config.py", "a") as config:
        config.write(setting)
    return folder / "course", f'c = get_config()\nc.CourseDirectory.course_id = "tam570"\n{setting}'


def scores(course):
    """(student, assignment, cell) -> the automatic score, by nbgrader's gradebook."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # nbgrader's own, of SQLAlchemy
        from nbgrader.api import Gradebook

        with Gradebook(f"sqlite:///{course / 'gradebook.db'}") as book:
            return {
                (submission.student_id, assignment.name, grade.name): grade.auto_score
                for assignment in book.assignments
                for submission in assignment.submissions
                for one in submission.notebooks
                for grade in one.grades
            }


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


def a_whole_term(checkout, folder, nbgrader, slips):
    """Release, fetch, work, submit, collect, autograde, feedback and export for two students."""
    course, config = made_course(checkout, folder, list(slips))
    homes = {name: folder / name for name in ("ann", "ben")}
    for home in homes.values():
        home.mkdir()
        (home / "nbgrader_config.py").write_text(config)
    for slug in slips:
        nbgrader(course, "generate_assignment", slug)
        nbgrader(course, "release_assignment", slug)
    for name, home in homes.items():
        assert all(slug in nbgrader(home, "list") for slug in slips)
        nbgrader(home, "fetch_assignment", *slips)
        for slug, slip in slips.items():
            solution = (checkout / "solutions" / f"{slug}.py").read_text()
            wrong = (TESTS / "wrong" / slug / f"{slip}.py").read_text() if name == "ben" else ""
            (home / slug / f"{slug}.py").write_text(f"{solution}\n\n{wrong}")
            nbgrader(home, "submit", slug, "--student", name)
    for slug in slips:
        nbgrader(course, "collect", slug)
        nbgrader(course, "autograde", slug)
        nbgrader(course, "generate_feedback", slug)
        nbgrader(course, "release_feedback", slug)
    for name, home in homes.items():
        for slug in slips:
            nbgrader(home, "fetch_feedback", slug, "--student", name)
    nbgrader(course, "export")
    return course, homes


def assert_the_same_scores(course, checkout, slips, out):
    """nbgrader's gradebook and its export hold the points of `tam570-grader grade`, part by part."""
    found, fractions = scores(course), 0
    rows = csv.DictReader((course / "grades.csv").read_text().splitlines())
    exported = {(row["student_id"], row["assignment"]): row for row in rows}
    for slug in slips:
        for record in regraded(course, checkout, slug, out / slug):
            who = (record["student"], slug)
            for part, points in by_part(record).items():
                assert found[(*who, f"part-{part}")] == pytest.approx(points, abs=1e-9)
            assert float(exported[who]["score"]) == pytest.approx(record["score"], abs=1e-9)
            fractions += sum(points % 1 != 0 for points in by_part(record).values())
            assert (record["score"] == record["max_score"]) == (record["student"] == "ann")
    assert fractions  # scores that are no whole numbers came through, too


def test_three_assignments_by_nbgraders_commands(course, tmp_path, nbgrader):
    made, homes = a_whole_term(course, tmp_path, nbgrader, IN_CI)
    assert_the_same_scores(made, course, IN_CI, tmp_path / "out")
    for slug in IN_CI:
        pages = [next((home / slug / "feedback").rglob("*.html")).read_text() for home in homes.values()]
        results = (made / "tam570_results" / slug / "results.jsonl").read_text().splitlines()
        ben = next(r for r in map(json.loads, results) if r["student"] == "ben")
        lost = [mark for mark in ben["checks"] if mark["outcome"] == "failed"]
        assert lost and all(mark["message"].split(";")[0][:40] in pages[1] for mark in lost)
        hidden = [text for mark in lost for text in mark["detail"].values()]
        assert hidden and not any(text in page for text in hidden for page in pages)


@pytest.mark.full
def test_all_fourteen_by_nbgraders_commands(course, tmp_path, nbgrader):
    slips = {slug: sorted((TESTS / "wrong" / slug).glob("*.py"))[0].stem for slug in root.slugs(course)}
    made, _ = a_whole_term(course, tmp_path, nbgrader, {**slips, **IN_CI})
    assert_the_same_scores(made, course, slips, tmp_path / "out")


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
    edited(
        folder,
        lambda cells: locked(cells)["metadata"]["nbgrader"].update(grade=False, schema_version=0, points=99),
    )


def renumbered(folder):
    edited(folder, lambda cells: locked(cells)["metadata"]["nbgrader"].update(grade_id="mine"))


def forged(folder):
    """The stub, with outputs in the notebook that claim points, and one that a browser would run."""
    shutil.copy(folder.parents[2] / "release" / ONE / f"{ONE}.py", folder)
    points = {
        "output_type": "execute_result",
        "execution_count": 1,
        "metadata": {},
        "data": {"text/plain": "10.0"},
    }
    script = {
        "output_type": "display_data",
        "metadata": {},
        "data": {"text/html": "<script>stolen()</script>"},
    }
    png = {
        "output_type": "display_data",
        "metadata": {},
        "data": {"image/png": '"><script>stolen()</script>'},
    }

    def forge(cells):
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
    (folder / f"{ONE}.py").symlink_to(root.find() / "solutions" / f"{ONE}.py")


FULL_MARKS = (as_it_is, noisy, changed, deleted, ungraded, renumbered, no_json, late)
NO_POINTS = {
    forged: "skew is not written yet",
    no_module: f"There is no {ONE}.py in the folder",
    renamed: f"There is no {ONE}.py in the folder",
    no_syntax: "Your file could not be read",
    linked: "is a link to a place outside of the submission",
}


@pytest.fixture(scope="module")
def odd_class(course, tmp_path_factory, nbgrader):
    """The course after autograde and generate_feedback, and what autograde said."""
    made, _ = made_course(course, tmp_path_factory.mktemp("odd"), [ONE])
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
def test_what_costs_nothing(odd_class, odd):
    made, _ = odd_class
    assert scores(made)[(odd.__name__, ONE, "part-a")] == 10.0
    assert "skew(v) r = v x r" in page_of(made, odd.__name__)


@pytest.mark.parametrize("odd", NO_POINTS, ids=lambda odd: odd.__name__)
def test_what_earns_nothing_and_why(odd_class, odd):
    made, _ = odd_class
    assert scores(made)[(odd.__name__, ONE, "part-a")] == 0.0
    assert NO_POINTS[odd] in page_of(made, odd.__name__)


def test_the_submitted_module_is_what_stays(odd_class, course):
    made, _ = odd_class
    kept = made / "autograded" / "as_it_is" / ONE / f"{ONE}.py"
    assert kept.read_text() == (course / "solutions" / f"{ONE}.py").read_text()


@pytest.mark.parametrize(
    "odd", [changed, deleted, ungraded, renumbered, no_json], ids=lambda odd: odd.__name__
)
def test_a_locked_cell_is_as_it_was_released(odd_class, odd):
    made, _ = odd_class
    released = locked(json.loads((made / "release" / ONE / f"{ONE}.ipynb").read_text())["cells"])
    found = locked(
        json.loads((made / "autograded" / odd.__name__ / ONE / f"{ONE}.ipynb").read_text())["cells"]
    )
    assert "".join(found["source"]).endswith("".join(released["source"]))
    assert found["metadata"]["nbgrader"]["points"] == 10.0


def test_a_notebook_that_does_not_parse_stays_in_submitted(odd_class):
    made, said = odd_class
    assert nb_of(made / "submitted" / "no_json" / ONE).read_text() == '{"cells": ['
    assert "could not be read" in page_of(made, "no_json") and "no_json" in said


def test_nothing_of_a_student_runs_in_the_teachers_browser(odd_class):
    made, _ = odd_class
    assert "stolen()" not in page_of(made, "forged")
    assert "<b>bold</b>" not in page_of(made, "no_syntax")


def test_late_work_is_graded_and_known_as_late(odd_class):
    _, said = odd_class
    assert "86400" in said.replace(".0", "")


def test_a_new_submission_is_graded_anew_with_the_same_inputs(odd_class, nbgrader, course):
    made, _ = odd_class
    shutil.copy(course / "solutions" / f"{ONE}.py", made / "submitted" / "renamed" / ONE)
    nbgrader(made, "autograde", ONE, "--student", "renamed", "--force")
    assert scores(made)[("renamed", ONE, "part-a")] == 10.0
    lines = (made / "tam570_results" / ONE / "results.jsonl").read_text().splitlines()
    assert len({json.loads(line)["seed"] for line in lines}) == 1
    assert len(lines) == len(FULL_MARKS) + len(NO_POINTS)


def test_a_submission_without_its_notebook_is_named_and_left(odd_class, nbgrader):
    made, _ = odd_class
    folder = made / "submitted" / "no_notebook" / ONE
    shutil.copytree(made / "submitted" / "as_it_is" / ONE, folder)
    nb_of(folder).unlink()
    assert "no_notebook" in nbgrader(made, "autograde", ONE, "--student", "no_notebook", fails=True)
    assert (folder / f"{ONE}.py").exists() and ("no_notebook", ONE, "part-a") not in scores(made)


# The notebook


def made_notebook(course, slug):
    released = course / "assignments" / slug
    texts = [(released / name).read_text() for name in ("README.md", f"test_{slug}.py")]
    return notebook(root.assignment(course, slug), *texts, (PICTURES / f"{slug}.md").read_text())


def test_every_part_has_its_text_and_its_points(course, slug):
    assignment, cells = root.assignment(course, slug), made_notebook(course, slug)["cells"]
    given = problem((course / "assignments" / slug / "README.md").read_text())
    graded = {
        one["metadata"]["nbgrader"]["grade_id"]: one["metadata"]["nbgrader"]["points"]
        for one in cells
        if one["metadata"]
    }
    assert given.parts and {*part_points(assignment), *assignment.manual} <= set(given.parts)
    assert {
        f"part-{part}": points for part, points in part_points(assignment).items()
    }.items() <= graded.items()
    assert {
        f"manual-{part}": points for part, (points, _) in assignment.manual.items()
    }.items() <= graded.items()
    assert sum(graded.values()) == assignment.max_score + sum(
        points for points, _ in assignment.manual.values()
    )
    assert len({one["id"] for one in cells}) == len(cells)


def test_every_visible_test_belongs_to_one_part_and_every_function_to_its_check(course, slug):
    assignment, text = (
        root.assignment(course, slug),
        (course / "assignments" / slug / f"test_{slug}.py").read_text(),
    )
    placed = [name for names in visible_by_part(assignment, text).values() for name in names]
    assert sorted(placed) == sorted(
        line[4:].split("(")[0] for line in text.splitlines() if line.startswith("def test_")
    )
    assert set(functions_by_part(assignment).values()) <= set(part_points(assignment))


def test_a_test_waits_for_the_last_part_that_it_uses(course):
    assignment = root.assignment(course, "hw12_bead_on_wire")
    one, two = "def test_one():\n    hw.lagrangian()\n", "def test_two():\n    both(), hw.lagrangian()\n"
    text = f"def both():\n    hw.period(1)\n{one}{two}"
    assert visible_by_part(assignment, text) == {"a": ["test_one"], "b": ["test_two"]}


def test_everything_that_a_student_gets_is_no_secret(course, tmp_path, slug):
    made, _ = made_course(course, tmp_path, [slug])
    names = {f"{slug}.py", f"{slug}.ipynb", f"test_{slug}.py", "README.md", "lab.py"}
    assert {path.name for path in (made / "source" / slug).iterdir()} == names
    assert (made / "source" / slug / f"{slug}.py").read_text() == stub(
        (course / "solutions" / f"{slug}.py").read_text()
    )


def test_a_course_that_is_made_again_keeps_what_the_teacher_changed(course, tmp_path):
    made, _ = made_course(course, tmp_path, [ONE])
    before = (made / "nbgrader_config.py").read_text()
    assert "Exchange.root" in before and cli.main(["--root", str(course), "course", str(made), ONE]) == 0
    assert (made / "nbgrader_config.py").read_text() == before


def run_top_to_bottom(course, folder, slug, module):
    """The outputs of the notebook beside this module, as text."""
    made, _ = made_course(course, folder, [slug])
    work = made / "source" / slug
    (work / f"{slug}.py").write_text(module)
    command = ["-m", "jupyter", "nbconvert", "--to", "notebook", "--execute", "--inplace", f"{slug}.ipynb"]
    done = subprocess.run([sys.executable, *command], cwd=work, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr[-2000:]
    cells = json.loads((work / f"{slug}.ipynb").read_text())["cells"]
    outputs = [one for cell in cells for one in cell.get("outputs", [])]
    assert not [one for one in outputs if one["output_type"] == "error" or one.get("name") == "stderr"]
    return "".join("".join(one.get("text", [])) for one in outputs), outputs


def assert_the_notebook_runs(course, folder, slug):
    """With the stub it says what is missing, with the solution it shows it."""
    solution = (course / "solutions" / f"{slug}.py").read_text()
    said, _ = run_top_to_bottom(course, folder / "stub", slug, stub(solution))
    assert "Nothing to see yet" in said and "is not written yet" in said
    said, outputs = run_top_to_bottom(course, folder / "solution", slug, solution)
    assert "Nothing to see" not in said and "This stopped" not in said and "\n- " not in said
    assert any({"image/png", "text/html"} & set(one.get("data", {})) for one in outputs)


def test_a_notebook_runs_with_the_stub_and_with_the_solution(course, tmp_path):
    assert_the_notebook_runs(course, tmp_path, ONE)


@pytest.mark.full
def test_every_notebook_runs_with_the_stub_and_with_the_solution(course, tmp_path, slug):
    assert_the_notebook_runs(course, tmp_path, slug)


def test_validate_says_whether_the_visible_tests_pass(course, tmp_path, nbgrader):
    made, _ = made_course(course, tmp_path, [ONE])
    nbgrader(made, "generate_assignment", ONE)
    work = made / "release" / ONE
    assert "Partial credit" in nbgrader(work, "validate", f"{ONE}.ipynb")
    shutil.copy(course / "solutions" / f"{ONE}.py", work)
    assert "Success" in nbgrader(work, "validate", f"{ONE}.ipynb")
