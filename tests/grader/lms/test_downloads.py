"""What goes to other systems: results and archives for Gradescope, tables for Canvas and Moodle."""

import csv
import json
import os
import re
import subprocess
import sys
import unicodedata
import zipfile

import pytest

from tam570_grader import cli
from tam570_grader.checks import assignments
from tam570_grader.checks import failure as failure_record
from tam570_grader.diagnosis.mistakes import overlays
from tam570_grader.gradescope import autograder
from tam570_grader.grading.one import failed_by_us
from tam570_grader.lms import score_export
from tam570_grader.lms.systems import SYSTEMS
from tam570_grader.release.stubs import stub
from tam570_grader.results import store, tables

ONE = "hw08_axis_angle"
FORMATS = {"text", "html", "simple_format", "md", "ansi"}
VISIBLE = {"hidden", "after_due_date", "after_published", "visible"}
# The specification of Gradescope, "Output format": each field and what it may hold.
WHOLE = {
    "score": lambda v: isinstance(v, int | float),
    "execution_time": lambda v: isinstance(v, int | float),
    "output": lambda v: isinstance(v, str),
    "output_format": FORMATS.__contains__,
    "test_output_format": FORMATS.__contains__,
    "test_name_format": FORMATS.__contains__,
    "visibility": VISIBLE.__contains__,
    "stdout_visibility": VISIBLE.__contains__,
    "extra_data": lambda v: isinstance(v, dict),
    "tests": lambda v: isinstance(v, list),
    "leaderboard": lambda v: isinstance(v, list),
}
TEST = {
    "score": lambda v: isinstance(v, int | float),
    "max_score": lambda v: isinstance(v, int | float),
    "status": {"passed", "failed"}.__contains__,
    "name": lambda v: isinstance(v, str),
    "name_format": FORMATS.__contains__,
    "number": lambda v: isinstance(v, str),
    "output": lambda v: isinstance(v, str),
    "output_format": FORMATS.__contains__,
    "tags": lambda v: isinstance(v, list),
    "visibility": VISIBLE.__contains__,
    "extra_data": lambda v: isinstance(v, dict),
}


def violations(found, schema):
    """The fields that the specification does not know, or not with such a value."""
    return [name for name, value in found.items() if name not in schema or not schema[name](value)]


def as_gradescope_reads_it(text):
    """The results, after every rule of the specification."""
    found = json.loads(text)
    assert not violations(found, WHOLE)
    assert not [name for test in found["tests"] for name in violations(test, TEST)]
    assert found["score"] == pytest.approx(sum(test["score"] for test in found["tests"]))
    return found


@pytest.fixture
def submission(tmp_path, solution_text):
    """`submission(text)` -> a folder with the module in it."""

    def submission(text=None):
        folder = tmp_path / "submission"
        folder.mkdir(exist_ok=True)
        (folder / f"{ONE}.py").write_text(solution_text(ONE) if text is None else text)
        return folder

    return submission


def test_the_schema_tells_right_from_wrong():
    assert violations({"score": "ten", "points": 3, "output_format": "rtf"}, WHOLE) == [
        "score",
        "points",
        "output_format",
    ]
    assert violations({"status": "not_run", "visibility": "visible"}, TEST) == ["status"]


@pytest.mark.parametrize("what", ["solution", "stub", "transposed", "no_syntax"])
def test_results_are_what_gradescope_accepts(course, submission, solution_text, capsys, what):
    solution = solution_text(ONE)
    wrong = overlays(assignments.checks_folder(course, ONE))["square_subtracted"]
    texts = {"solution": solution, "stub": stub(solution), "transposed": solution + wrong, "no_syntax": "def f(:"}
    grade = ["grade", str(submission(texts[what])), "--assignment", ONE, "--seed", "3", "--format", "gradescope"]
    assert cli.main(["--root", str(course), *grade]) == 0
    found = as_gradescope_reads_it(capsys.readouterr().out)
    assert (found["score"] == 10) == (what == "solution") and (found["score"] == 0) == (what in ("stub", "no_syntax"))
    assert sum(test["max_score"] for test in found["tests"]) == 10
    assert all(test["output"] for test in found["tests"] if test["status"] == "failed")
    assert bool(found["output"]) == (what == "no_syntax")


def test_results_hold_nothing_hidden(course, grade, solution_text):
    wrong = overlays(assignments.checks_folder(course, ONE))["square_subtracted"]
    record = grade(ONE, solution_text(ONE) + wrong).record()
    failed = [mark["failure"] for mark in record["checks"] if "failure" in mark]
    hidden = re.findall(
        r"\d\.\d{6,}|[A-Za-z0-9+/]{40,}",
        json.dumps([failure.get(key) for failure in failed for key in failure_record.WHOLE]),
    )
    page = json.dumps(autograder.results(record, {}))
    assert hidden and not any(json.dumps(text)[1:-1] in page for text in hidden)


def test_two_submissions_are_not_one(course, tmp_path, submission, capsys):
    folder = submission()
    command = ["grade", str(folder), str(folder / f"{ONE}.py"), "--assignment", ONE, "--format", "gradescope"]
    assert cli.main(["--root", str(course), *command]) == 2
    assert "one submission" in capsys.readouterr().err


def test_a_failure_of_ours_leaves_no_results(course, submission, capsys, monkeypatch):
    broken = failed_by_us("s", assignments.assignment(course, ONE), "a bug", 3).record()
    monkeypatch.setattr("tam570_grader.grading.batch.outcomes", lambda plan, book, old: iter([broken]))
    grade = ["grade", str(submission()), "--assignment", ONE, "--format", "gradescope"]
    assert cli.main(["--root", str(course), *grade]) == 1
    assert capsys.readouterr().out == ""


@pytest.fixture
def container(course, tmp_path, submission):
    """A folder laid out as Gradescope's /autograder, with the archive unpacked and a submission in it."""
    assert cli.main(["--root", str(course), "gradescope", str(tmp_path), ONE]) == 0
    submission()
    with zipfile.ZipFile(tmp_path / f"{ONE}.zip") as archive:
        archive.extractall(tmp_path / "source")
        assert all(archive.getinfo(name).external_attr >> 16 & 0o111 for name in ("setup.sh", "run_autograder"))
    return tmp_path


@pytest.mark.parametrize("more", ["", "hw08_axis_angle/notes.txt", "docs/plan.md", "hw07_double_pendulum/hw07.py"])
@pytest.mark.parametrize("place", ["", "homework", "a/b"])
def test_a_folder_beside_the_work_costs_no_result(course, submission, capsys, place, more):
    folder = submission()
    (folder / place).mkdir(parents=True, exist_ok=True)
    (folder / f"{ONE}.py").rename(folder / place / f"{ONE}.py")
    if more:
        (folder / more).parent.mkdir(exist_ok=True)
        (folder / more).write_text("x = 1\n")
    grade = ["grade", str(folder), "--assignment", ONE, "--seed", "3", "--format", "gradescope"]
    assert cli.main(["--root", str(course), *grade]) == 0
    assert as_gradescope_reads_it(capsys.readouterr().out)["score"] == 10


def test_the_archive_grades_by_itself(container):
    course = container / "source" / "course"
    ours = os.pathsep.join([str(course / "shared"), str(course / "autograder")])
    environment = {"PATH": os.environ["PATH"], "PYTHON": sys.executable, "PYTHONPATH": ours}
    run = ["sh", str(container / "source" / "run_autograder")]
    done = subprocess.run(run, cwd="/", env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert as_gradescope_reads_it((container / "results" / "results.json").read_text())["score"] == 10


def test_the_archive_holds_one_assignment_and_shell_scripts_that_parse(container):
    source = container / "source"
    assert [path.stem for path in (source / "course" / "solutions").iterdir()] == [ONE]
    assert [path.stem for path in (source / "course" / "autograder" / "checks").iterdir()] == [ONE]
    for name in ("setup.sh", "run_autograder"):
        subprocess.run(["sh", "-n", str(source / name)], check=True)


def test_an_archive_keeps_one_seed_for_the_class_and_shows_it_to_nobody(container, tmp_path):
    seed = (container / "source" / "seed").read_text().strip()
    assert int(seed) > 2**64 and seed not in (container / "source" / "run_autograder").read_text()
    with zipfile.ZipFile(tmp_path / f"{ONE}.zip") as archive:
        assert archive.getinfo("seed").external_attr >> 16 & 0o777 == 0o600


SCORES = {("ann", "hw07_x"): ("9.5", "10.0"), ("ben", "hw07_x"): ("", "10.0"), ("ann", "hw08_y"): ("10.0", "10.0")}
ROSTER = [
    ["Student", "ID", "SIS User ID", "SIS Login ID", "Section", "hw07_x (4711)", "Final Score"],
    ["    Points Possible", "", "", "", "", "10", "(read only)"],
    ["Lee, Ann", "17", "A1", "ann", "570", "", ""],
    ["Ray, Cho", "18", "A3", "cho", "570", "", ""],
]


def export(tmp_path, system, scores=SCORES, roster=None, **options):
    """The table for a system, with a roster of these rows or without one."""
    path = tmp_path / "roster.csv" if roster else None
    if path:
        tables.write_table(path, roster, exact=True)
    return score_export.export(scores, SYSTEMS[system].table, path, **options)


def test_canvas_without_a_roster_knows_students_by_login(tmp_path):
    table = export(tmp_path, "canvas").rows
    assert table[0] == ["Student", "ID", "SIS User ID", "SIS Login ID", "Section", "hw07_x", "hw08_y"]
    assert table[1] == ["    Points Possible", "", "", "", "", "10.0", "10.0"]
    assert table[2:] == [["ann", "", "", "ann", "", "9.5", "10.0"], ["ben", "", "", "ben", "", "", ""]]


def test_canvas_with_a_roster_keeps_its_names_numbers_and_columns(tmp_path):
    table = export(tmp_path, "canvas", roster=ROSTER, new=True).rows
    assert table[0][5:] == ["hw07_x (4711)", "hw08_y"]
    assert table[2:] == [["Lee, Ann", "17", "A1", "ann", "570", "9.5", "10.0"], [*ROSTER[3][:5], "", ""]]


@pytest.mark.parametrize("name", ["17", "A1"])
def test_canvas_finds_a_student_by_any_of_its_numbers(tmp_path, name):
    made = export(tmp_path, "canvas", {(name, "hw07_x"): ("9.5", "10.0")}, ROSTER)
    assert made.rows[2][5:] == ["9.5"]


def test_moodle_knows_students_by_the_field_that_is_named(tmp_path):
    assert export(tmp_path, "moodle", identity="email").rows[0] == ["Email address", "hw07_x", "hw08_y"]
    assert export(tmp_path, "moodle").rows[1:] == [["ann", "9.5", "10.0"], ["ben", "", ""]]


@pytest.mark.parametrize("system, who", [("canvas", 3), ("moodle", 0)])
def test_the_grades_of_a_run_arrive(course, tmp_path, submission, system, who):
    submission()
    assert (
        cli.main(["--root", str(course), "grade", str(tmp_path / "submission" / f"{ONE}.py"), "--out", str(tmp_path)])
        == 0
    )
    out = tmp_path / "table.csv"
    assert cli.main(["lms", str(tmp_path / "grades.csv"), "--to", system, "--out", str(out)]) == 0
    with open(out, newline="") as file:
        heading, *_, row = csv.reader(file)
    assert heading[-1] == ONE and row[who] == ONE and float(row[-1]) == 10


def test_nbgraders_export_will_do(tmp_path, capsys):
    export = "assignment,duedate,timestamp,student_id,raw_score,score,max_score\nhw07_x,,,ann,9,8.5,12\n"
    (tmp_path / "grades.csv").write_text(export)
    assert cli.main(["lms", str(tmp_path / "grades.csv"), "--to", "moodle"]) == 0
    assert capsys.readouterr().out.splitlines() == ["Username,hw07_x", "ann,8.5"]


NAMES = ["ann", "'ann", "+1", "'+1", "''=1", "-rf", "@x", "\tx", "\rx", "\uff1d1", "\uff0b1", "\uff0d1", "\uff20x"]


@pytest.mark.parametrize("name", NAMES)
def test_a_cell_is_no_formula_and_tells_the_name(name):
    assert unicodedata.normalize("NFKC", tables.cell(name))[0] not in "=+-@\t\r"
    assert tables.name_in(tables.cell(name)) == name
    assert (tables.cell(name) == name) == (name in NAMES[:2])


@pytest.fixture
def grades(tmp_path):
    """A table of grades of students with odd names."""
    rows = [(name, "hw07_x", "graded", 9.5, 10.0) for name in ("+1", "ann")]
    (tmp_path / "grades.csv").write_text(store.grades(rows))
    return tmp_path / "grades.csv"


def test_a_login_that_could_be_a_formula_is_matched_as_it_is_and_warned_of(grades, capsys):
    roster = grades.with_name("roster.csv")
    with open(roster, "w", newline="") as file:
        csv.writer(file).writerows([*ROSTER[:2], ["Lee, Ann", "17", "A1", "+1", "570", "", ""]])
    lms = ["lms", str(grades), "--to"]
    assert cli.main([*lms, "canvas", "--roster", str(roster)]) == 1  # ann is on no row
    out, err = capsys.readouterr()
    assert out.splitlines()[-1] == '"Lee, Ann",17,A1,+1,570,9.5' and "formulas: '+1'" in err
    assert cli.main([*lms, "moodle"]) == 0
    out, err = capsys.readouterr()
    assert out.splitlines()[1:] == ["+1,9.5", "ann,9.5"] and "formulas: '+1'" in err
    assert cli.main([*lms, "canvas"]) == 0
    assert "\n'+1,,,+1,,9.5" in capsys.readouterr().out


def test_names_without_a_sign_are_not_warned_of(grades, capsys):
    grades.write_text(grades.read_text().replace("'+1", "ben"))
    assert cli.main(["lms", str(grades), "--to", "moodle"]) == 0
    assert "warning" not in capsys.readouterr().err


@pytest.mark.parametrize("row", ["ann,hw07_x", "ann,hw07_x,9,10,"])
def test_a_row_that_does_not_fit_the_heading_is_shown(tmp_path, capsys, row):
    (tmp_path / "grades.csv").write_text(f"student,assignment,score,max_score\n{row}\n")
    assert cli.main(["lms", str(tmp_path / "grades.csv"), "--to", "moodle"]) == 2
    assert f"4 columns: {row}" in capsys.readouterr().err


@pytest.mark.parametrize("text", ["", "a,b\n1,2\n"])
def test_what_is_no_table_of_grades_is_refused(tmp_path, capsys, text):
    (tmp_path / "grades.csv").write_text(text)
    assert cli.main(["lms", str(tmp_path / "grades.csv"), "--to", "canvas"]) == 2
    assert "grades.csv" in capsys.readouterr().err
