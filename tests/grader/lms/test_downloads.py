"""Output for other systems: results and archives for Gradescope, tables and pages for Canvas and Moodle."""

import json
import os
import re
import subprocess
import sys
import unicodedata
import zipfile

import pytest
from classes import HW08, hand_in

from tam570_grader.checks import assignments
from tam570_grader.checks.failure import WHOLE
from tam570_grader.diagnosis.mistakes import overlays
from tam570_grader.gradescope import autograder
from tam570_grader.grading.run_checks import failed_by_us
from tam570_grader.release.stubs import stub
from tam570_grader.results import tables
from tam570_grader.results.manual_points import GradeRow

FORMATS = {"text", "html", "simple_format", "md", "ansi"}
VISIBLE = {"hidden", "after_due_date", "after_published", "visible"}
# Gradescope's specification, "Output format": the types or words that each field may have.
FIELDS = {
    **dict.fromkeys(("score", "max_score", "execution_time"), int | float),
    **dict.fromkeys(("output", "name", "number"), str),
    **dict.fromkeys(("tests", "leaderboard", "tags"), list),
    **dict.fromkeys(("output_format", "test_output_format", "test_name_format", "name_format"), FORMATS),
    **dict.fromkeys(("visibility", "stdout_visibility"), VISIBLE),
    "status": {"passed", "failed"},
    "extra_data": dict,
}
ROSTER = [
    ["Student", "ID", "SIS User ID", "SIS Login ID", "Section", "hw07_x (4711)", "Final Score"],
    ["    Points Possible", "", "", "", "", "10", "(read only)"],
    ["Lee, Ann", "17", "A1", "ann", "570", "", ""],
    ["Ray, Cho", "18", "A3", "cho", "570", "", ""],
]
NAMES = ["ann", "'ann", "+1", "'+1", "''=1", "-rf", "@x", "\tx", "\rx", "\uff1d1", "\uff0b1", "\uff0d1", "\uff20x"]
SPLIT = ["a;=1+1", "x\t@sum", "'=1;'-2", "a;b;;+c", "ok\n=2"]
# The names of feedback pages are derived from the names of the downloaded files.
HEADING = "student,name,assignment,file,when,late,from,note\n"
CANVAS = [
    f"ann,,{HW08},{HW08}.py,,,adamsann_17_600_hw08_axis_angle-2.py,",
    f"ann,,{HW08},,,,adamsann_17_500_hw08_axis_angle.py,older",
    f"bo,,{HW08},{HW08}.py,,LATE,all/brownbo_LATE_18_550_hw08.zip/mine/hw08.py,",
]
MOODLE = [
    f"ann,,{HW08},{HW08}.py,,,Ann Adams_17_assignsubmission_file_Bo Brown_18_assignsubmission_file_hw08.py,",
    f"bo,,{HW08},{HW08}.py,,,Bo Brown_18_assignsubmission_file/hw08.py,",
]
NBGRADER = """assignment,duedate,timestamp,student_id,raw_score,score,max_score
hw01_x,,2026-02-03,ann,9,9.0,12
hw01_x,,,bo,0,0.0,12
hw10_x,,,ann,0,0.0,10
hw10_x,,,bo,0,0.0,10
"""
OURS = """student,assignment,status,score,max_score
ann,hw01_x,graded,0.0,12.0
bo,hw01_x,missing,0.0,12.0
cy,hw01_x,missing,8.0,12.0
"""


def as_gradescope_reads_it(text):
    """Return the results; assert that they follow every rule of the specification."""
    record = json.loads(text)
    for name, value in (item for part in (record, *record["tests"]) for item in part.items()):
        assert value in FIELDS[name] if isinstance(FIELDS[name], set) else isinstance(value, FIELDS[name]), name
    assert record["score"] == pytest.approx(sum(test["score"] for test in record["tests"]))
    return record


@pytest.fixture
def submission(tmp_path, solution_text):
    """Return a folder that contains the solution."""
    return hand_in(tmp_path, {"submission": solution_text(HW08)}, file="{0}.py") / "submission"


def for_gradescope(desk, submission):
    """Return the exit code and the JSON that the command prints for Gradescope."""
    code, said = desk("grade", submission, "--assignment", HW08, "--seed", "3", "--format", "gradescope")
    return code, said[: said.rfind("}") + 1]


@pytest.mark.parametrize("what", ["solution", "stub", "transposed", "no_syntax"])
def test_results_are_what_gradescope_accepts(course, desk, submission, solution_text, what):
    solution = solution_text(HW08)
    wrong = overlays(assignments.checks_folder(course, HW08))["square_subtracted"]
    texts = {"solution": solution, "stub": stub(solution), "transposed": solution + wrong, "no_syntax": "def f(:"}
    (submission / f"{HW08}.py").write_text(texts[what])
    code, printed = for_gradescope(desk, submission)
    record = as_gradescope_reads_it(printed)
    assert code == 0 and sum(test["max_score"] for test in record["tests"]) == 10
    assert (record["score"] == 10) == (what == "solution") and (record["score"] == 0) == (what in ("stub", "no_syntax"))
    assert all(test["output"] for test in record["tests"] if test["status"] == "failed")
    assert bool(record["output"]) == (what == "no_syntax")


def test_results_hold_nothing_hidden(course, grade, solution_text):
    wrong = overlays(assignments.checks_folder(course, HW08))["square_subtracted"]
    record = grade(HW08, solution_text(HW08) + wrong).record()
    details = [check["failure"].get(key) for check in record["checks"] if "failure" in check for key in WHOLE]
    hidden = re.findall(r"\d\.\d{6,}|[A-Za-z0-9+/]{40,}", json.dumps(details))
    page = json.dumps(autograder.results(record, {}))
    assert hidden and not any(json.dumps(text)[1:-1] in page for text in hidden)


def test_a_failure_of_ours_leaves_no_results(course, desk, submission, monkeypatch):
    broken = failed_by_us("s", assignments.assignment(course, HW08), "a bug", 3).record()
    monkeypatch.setattr("tam570_grader.cli.grade.records", lambda config, store, old: iter([broken]))
    assert for_gradescope(desk, submission) == (1, "")


@pytest.mark.parametrize(
    ("folder", "more"),
    [("", "docs/plan.md"), ("a/b", ""), ("homework", f"{HW08}/notes.txt"), ("", "hw07_double_pendulum/hw07.py")],
)
def test_a_folder_beside_the_work_costs_no_result(desk, submission, folder, more):
    (submission / folder).mkdir(parents=True, exist_ok=True)
    (submission / f"{HW08}.py").rename(submission / folder / f"{HW08}.py")
    if more:
        (submission / more).parent.mkdir(exist_ok=True)
        (submission / more).write_text("x = 1\n")
    assert as_gradescope_reads_it(for_gradescope(desk, submission)[1])["score"] == 10


def test_the_archive_grades_by_itself(desk, submission):
    """The unpacked archive grades a submission in a folder with the layout of Gradescope's /autograder."""
    assert desk("gradescope", ".", HW08)[0] == 0
    source = desk.folder / "source"
    with zipfile.ZipFile(f"{HW08}.zip") as archive:
        archive.extractall(source)
        assert all(archive.getinfo(name).external_attr >> 16 & 0o111 for name in ("setup.sh", "run_autograder"))
        assert archive.getinfo("seed").external_attr >> 16 & 0o777 == 0o600
    seed = (source / "seed").read_text().strip()
    assert int(seed) > 2**64 and seed not in (source / "run_autograder").read_text()
    for part in ("solutions", "autograder/checks"):
        assert [path.stem for path in (source / "course" / part).iterdir()] == [HW08]
    subprocess.run(["sh", "-n", source / "setup.sh"], check=True)
    ours = os.pathsep.join(str(source / "course" / part) for part in ("shared", "autograder"))
    environment = {"PATH": os.environ["PATH"], "PYTHON": sys.executable, "PYTHONPATH": ours}
    done = subprocess.run(["sh", source / "run_autograder"], cwd="/", env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert as_gradescope_reads_it((desk.folder / "results" / "results.json").read_text())["score"] == 10


@pytest.mark.parametrize("name", NAMES + SPLIT)
def test_a_cell_is_no_formula_and_tells_the_name(name):
    cell = tables.cell(name)
    for piece in re.split(r"[;\t\n]", cell[1:] if cell[0] in "\t\r" else cell):
        assert unicodedata.normalize("NFKC", piece or "x")[0] not in "=+-@\t\r"
    assert tables.name_in(cell) == name and (cell == name) == (name in NAMES[:2])


def test_a_login_that_could_be_a_formula_is_matched_as_it_is_and_warned_of(desk):
    graded = [(name, "hw07_x", "graded", 9.5, 10.0) for name in ("+1", "ann")]
    tables.write_table(desk.folder / "grades.csv", [GradeRow._fields, *graded])
    desk.write("roster.csv", [*ROSTER[:2], ["Lee, Ann", "17", "A1", "+1", "570", "", ""]])
    code, said = desk("lms", "grades.csv", "--to", "canvas", "--roster", "roster.csv")
    assert code == 1 and '"Lee, Ann",17,A1,+1,570,9.5' in said and "formulas: '+1'" in said  # ann is not on the roster
    code, said = desk("lms", "grades.csv", "--to", "moodle")
    assert code == 0 and "+1,9.5\nann,9.5" in said.replace("\r", "") and "formulas: '+1'" in said
    assert "\n'+1,,,+1,,9.5" in desk("lms", "grades.csv", "--to", "canvas")[1]


@pytest.fixture
def hand_back(desk):
    """`hand_back(system, rows, *more)` -> (exit code, {name: text} of the zip file of pages)."""
    desk.write_grades({"ann": 9, "bo": 8})
    for student in ("ann", "bo"):
        (desk.folder / "feedback" / student).mkdir(parents=True)
        desk.write(f"feedback/{student}/{HW08}.html", f"page of {student}")

    def hand_back(system, rows, *more):
        desk.write("collected.csv", HEADING + "".join(f"{row}\n" for row in rows))
        pages = ["--pages", "pages.zip", "--collected", "collected.csv", "--out", "table.csv"]
        code, _ = desk("lms", "grades.csv", "--to", system, *pages, *more)
        if not (desk.folder / "pages.zip").exists():
            return code, {}
        with zipfile.ZipFile("pages.zip") as archive:
            return code, {name: archive.read(name).decode() for name in archive.namelist()}

    return hand_back


@pytest.mark.parametrize(
    ("system", "rows", "ann", "bo"),
    [
        ("canvas", CANVAS, f"adamsann_17_600_{HW08}.html", f"brownbo_LATE_18_550_{HW08}.html"),
        ("moodle", MOODLE, *(f"{who}_assignsubmission_file_{HW08}.html" for who in ("Ann Adams_17", "Bo Brown_18"))),
    ],
)
def test_a_page_goes_to_who_handed_in(hand_back, desk, system, rows, ann, bo):
    assert hand_back(system, rows) == (0, {ann: "page of ann", bo: "page of bo"})
    (desk.folder / "pages.zip").unlink()
    assert hand_back(system, MOODLE if rows is CANVAS else CANVAS) == (2, {})
    (desk.folder / "feedback" / "bo" / f"{HW08}.html").unlink()
    assert hand_back(system, rows) == (1, {ann: "page of ann"})


def test_a_zip_file_holds_the_pages_of_one_assignment(hand_back, desk):
    rows = [*MOODLE, "ann,,hw07_x,hw07_x.py,,,Ann Adams_17_assignsubmission_file/hw07.py,"]
    grades = f"student,assignment,status,score,max_score\nann,hw07_x,graded,9,10\nann,{HW08},graded,9,10\n"
    desk.write("grades.csv", grades)
    assert hand_back("moodle", rows) == (2, {})
    code, actual = hand_back("moodle", rows, "--only", "hw08")
    assert code == 0 and len(actual) == 2 and all(HW08 in name for name in actual)


@pytest.mark.parametrize(
    ("table", "more", "lines"),
    [
        (NBGRADER, [], ["Username,hw01_x,hw10_x", "ann,9.0,", "bo,0.0,"]),  # nobody handed in hw10
        (NBGRADER, ["--only", "hw1"], ["Username,hw01_x", "ann,9.0", "bo,0.0"]),
        (NBGRADER, ["--only", "hw1", "--absent", "blank"], ["Username,hw01_x", "ann,9.0", "bo,"]),
        (OURS, [], ["Username,hw01_x", "ann,0.0", "bo,0.0", "cy,8.0"]),
        (OURS, ["--absent", "blank", "--identity", "email"], ["Email address,hw01_x", "ann,0.0", "bo,", "cy,8.0"]),
    ],
)
def test_who_is_absent_has_zero_or_a_blank(desk, table, more, lines):
    desk.write("grades.csv", table)
    assert desk("lms", "grades.csv", "--to", "moodle", "--out", "up.csv", *more)[0] == 0
    assert (desk.folder / "up.csv").read_text().splitlines() == lines
